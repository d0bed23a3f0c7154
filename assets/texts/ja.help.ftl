# コマンドと引数の説明 (日本語)。英語は src/cli の定義にある。キー：help、コマンド、引数の名前。

## 見出し
heading-usage = 使い方：
heading-commands = コマンド
heading-arguments = 引数
heading-options = オプション
help-of-help = この説明を表示する
help-of-version = 版を表示する
help-of-commands = 全体またはコマンドの説明を表示する
help-default = 既定：
help-choices = 次のどれか：

## 引数の誤り
mistake-command = そのコマンドはない
mistake-argument = その引数はない
mistake-missing = 必須の引数がない
mistake-value = 使えない値
mistake-no-value = 値がない
mistake-conflict = ともに与えられない引数
mistake-count = 値の数が違う
mistake-letters = UTF-8 の文字でない引数
mistake-choices = 使える値：
mistake-more = 詳しくは --help

## 全体
help-about = 衝突し、固着し、滑り、回転する橋桁
help-long = 衝突し、固着し、滑り、回転する橋桁。コマンドを与えなければ作業画面を開く。表示装置がなければ、最初のシーンの図と表を書く。
help-out = 表示装置がないときに図と表を書くフォルダー
help-lang = 表示の言語、en または ja。与えなければシステムの言語、作業画面では前回そこで選んだ言語

## open
help-open-about = シーンを作業画面で開く
help-open-scene = シーンのファイル、または例題の名前
help-open-sets = シーンの値を変える。例：`--set motion.angle_deg=45 --set girder.deck.skew_deg=60`
help-open-until = シーンの `duration_s` によらず、この時刻まで計算する [s]
help-open-tolerance = シーンの `solver.tolerance` によらない、1ステップの局所誤差

## run
help-run-about = シーンを計算する：要約を表示し、表をフォルダーに書く
help-run-scene = シーンのファイル、または例題の名前 (一覧は `girderbench presets`)
help-run-sample = 表の毎秒の行数 [Hz]
help-run-threads = 計算に使うスレッドの数 (スイープの各計算、組のない物体ごと)。省くと `RAYON_NUM_THREADS`、なければプロセッサごとに1つ
help-run-out = trajectory.csv、contacts.csv、events.csv、summary.json をこのフォルダーに書く。装置、降伏する・滑る・支持を失いうる支承、背面土があれば devices.csv も。衝撃モデルでは hits.csv と transitions.csv も、シーンが両方のモデルを求めるときは接触モデルの表に加えて impact-….csv も書く
help-run-digest = 結果全体のハッシュだけを表示する

## report
help-report-about = シーンを計算し、人に渡す1ページの報告書を書く：シーン、仮定、運動、最大の衝突、桁かかりと基準、誤差
help-report-out = 報告書。図をすべて含む1つの HTML ファイル

## check
help-check-about = シーンを検査し、読み取った内容を表示する

## compare
help-compare-about = 2つの結果を計算または読み込み、どこで分かれるかを表示する
help-compare-a = シーンのファイル、例題、または `run --out` が書いたフォルダー
help-compare-b = 同じ
help-compare-sample = 計算する結果の毎秒の行数 [Hz]。省くと 100
help-compare-within = 2つの量が分かれたとみなす差、最大値に対する比

## motion
help-motion-about = 地震動の記録の内容を示す：形式、単位、最大値、継続時間。図と応答スペクトル
help-motion-files = 記録のファイル：PEER AT2、K-NET、COSMOS、CSMIP Volume 2、1列、CSV
help-motion-channel = 各ファイルのこの成分だけ (1 から数える)
help-motion-dt = 時間刻み、ファイルに書かれていないとき [s]
help-motion-unit = 数値の単位、ファイルに書かれていないとき：g、gal (cm/s2)、m/s2
help-motion-out = 各成分の時刻歴と 5 % 応答スペクトルを、図と CSV でこのフォルダーに書く
help-motion-from = 記録をここから切り出す、ファイルの時刻 [s]
help-motion-to = 記録をここまで切り出す、ファイルの時刻 [s]
help-motion-baseline = 平均、最小二乗の直線、または速度を最小にする放物線を差し引く：none, mean, linear, berg-housner
help-motion-taper = 始めの立上がりと終わりの立下がりの余弦テーパーの長さ [s]
help-motion-pad = 始めの前と終わりの後の静止 [s]
help-motion-time_scale = 時間刻みの倍率
help-motion-peak_g = 最大値をこれに合わせる [g]
help-motion-scale = ほかの処理の後ですべての値に掛ける倍率

## plot
help-plot-about = 計算の量を時刻または互いに対して図示する (履歴曲線など)。`--y` がなければ量の名前の一覧
help-plot-y = 縦軸の量、例：`deck.bearing1.force-x`。何度でも与えられる
help-plot-x = 横軸の量、例：`deck.bearing1.x`。省くと時刻
help-plot-sample = 毎秒の点の数 [Hz]
help-plot-out = plot.csv、plot.svg、plot.png をこのフォルダーに書く
help-plot-list = 計算の量の名前だけをすべて表示する

## identify
help-identify-about = 測定した変位 (自由減衰、既知の地動、スイープ) から固有振動数と減衰定数を求める。--fit では衝突する桁の遊間、反発係数、摩擦係数を求める
help-identify-file = 時刻と地盤に対する変位の CSV の表。--response では振動数と振幅の表
help-identify-column = 変位の列の名前。1列だけなら省ける
help-identify-unit = 変位の単位、見出しに書かれていないとき (`x_mm` のように)：m, cm, mm, um
help-identify-from = この時刻から後だけ。自由減衰では自由になる時刻 [s]
help-identify-to = この時刻までだけ [s]
help-identify-scene = このシーンまたは例題の地動による。t = 0 はその始まり
help-identify-sets = そのシーンの値を変える。例：`--set motion.kind=sweep`
help-identify-along = そのシーンでの変位の向き、全体座標の x から [度]
help-identify-record = この記録で変位の向きに加振した。`girderbench motion` が読むファイル
help-identify-channel = 記録のどの成分か (1 から数える)
help-identify-dt = その時間刻み、書かれていないとき [s]
help-identify-record_unit = その数値の単位、書かれていないとき：g、gal (cm/s2)、m/s2
help-identify-scaled = 地動は倍率を除いて既知とし、倍率も求める
help-identify-response = 表は、加速度振幅が一定の正弦波による定常変位の振幅を振動数に対して示す
help-identify-amplitude_g = その正弦波の振幅、既知のとき [g]
help-identify-fit = シーンのこのキーの値を START から始めて求める。シーンを計算し、列 `GIRDER.x` と、あれば `GIRDER.y` に合わせる：`--fit contact.restitution_normal=0.5 --fit abutment.wall.gap_m=0.004`
help-identify-girder = 測定した桁。シーンの桁が1つなら省ける
help-identify-frequency = 固有振動数を既知とし、論文の共振時のように減衰定数だけを求める [Hz]
help-identify-out = 図、表、JSON をこのフォルダーに書く

## measure
help-measure-about = 標点の写真から物体の運動を求める：時刻に対する x、y、回転角
help-measure-pictures = 名前の順に並べた PNG の写真のフォルダー、または写真そのもの
help-measure-layout = 何にどこで標点を付けたかを書いた TOML。省くと写真と同じ場所の `marks.toml`、それもなければ最初の写真のすべての標点を1つの物体のものとする
help-measure-fps = 配置の記述によらない毎秒の写真の数。配置がなければ 30 [Hz]
help-measure-mm_per_pixel = 配置の記述によらない1画素の長さ [mm]
help-measure-threshold = これより明るい画素を標点とする、0 から 255。省くと背景と最も明るい画素の中間
help-measure-least_pixels = 標点の最小の画素数
help-measure-scene = このシーンまたは例題の計算と比べる
help-measure-sets = そのシーンの値を変える
help-measure-run = `girderbench run --out` がこのフォルダーに書いた結果と比べる
help-measure-out = 表、JSON、図をこのフォルダーに書く

## study
help-study-about = プログラムを測る：誤差に対する計算量、規模に対する計算量、乱数によるシーン、論文の実験、動画
help-study-accuracy-about = 誤差に対する計算量を測る：すべての解法をすべての問題で
help-study-accuracy-problems = 問題。名前がなければすべて
help-study-accuracy-out = README.md、results.csv、図をこのフォルダーに書く
help-study-accuracy-methods = 解法、コンマ区切り。名前がなければすべて
help-study-accuracy-repeat = 準備の1回の後に時間を測る回数。最小の値をとる
help-study-accuracy-quick = 設定を減らしスイープを短くする：約1分で終わる
help-study-accuracy-date = ページに書く測定の日
help-study-accuracy-machine = ページに書く計算機の名前
help-study-camera-about = 標点の動画の精度を測る：標点の大きさ、解像度、露光時間、雑音、量子化に対する誤差
help-study-camera-out = camera.md、camera.csv、図をこのフォルダーに書く
help-study-experiment-about = 論文の実験を計算する：表2のすべての条件を両モデルで、図と所見を1ページに
help-study-experiment-out = report.html、findings.md、maps/、results/ をこのフォルダーに書く。すでにある結果は計算し直さない
help-study-experiment-only = これらだけ、コンマ区切り：条件 (`skew60_-15_0.40g`)、straight、skew60、skew45、pair の全体、または maps
help-study-experiment-record = 地震動、`girderbench motion` が読む記録のファイル。なければ模擬地震動
help-study-experiment-channel = ファイルのどの成分か (1 から数える)
help-study-experiment-dt = 時間刻み、ファイルに書かれていないとき (1つの記録) [s]
help-study-experiment-unit = 数値の単位、ファイルに書かれていないとき (1つの記録)：g、gal (cm/s2)、m/s2
help-study-experiment-record_scale = 地震動の倍率。論文には書かれていない
help-study-laws-about = 法線方向の接触則を比べる：1回の衝突、10 秒間、食い込みに対する力
help-study-laws-out = laws.md、laws.csv、図をこのフォルダーに書く
help-study-size-about = 規模に対する計算量を測る：1 から 1000 本の桁の列
help-study-size-out = size.md、size.csv、図をこのフォルダーに書く
help-study-size-quick = 100 本までの列だけ
help-study-stability-about = 広い範囲の乱数によるシーン：どの計算も終わり、収支が合い、見落としがなく、収束するか
help-study-stability-seeds = 種の数
help-study-stability-from = 最初の種
help-study-stability-inside = シーンが検証範囲内にある種だけをとる
help-study-stability-out = seeds.csv、stability.md、縮小した失敗シーンをこのフォルダーに書く
help-study-stability-threads = 同時に計算する種の数。省くとプロセッサの数
help-study-stability-events = シーンを十分長いとみなすイベントの数 (1時間揺れるものを除く)
help-study-stability-patience = 1つの種の計算に許すプロセッサ時間の上限 [s]

## sweep
help-sweep-about = キーの多くの値でシーンを計算する：データセットと分布図
help-sweep-long = キーの多くの値でシーンを計算する：データセットと分布図。終わった計算はその都度フォルダーに残り、途中でどう止まっても同じコマンドで続きから計算する。量の一覧と、計算機に分ける方法は docs/sweep.md にある。
help-sweep-vary = --set と同じ書き方のキーとその値：並び `a,b,c`、等間隔 `LO..HI:N`、等比 `LO..HI:N:log`、またはその組合せ。何度も与えると全ての組合せを計算する
help-sweep-measure = 各計算から残す量、コンマ区切り。使える量は下にある
help-sweep-out = スイープのフォルダー：sweep.csv、sweep.parquet、図、続きに要るもの
help-sweep-shard = N 個に分けた I 番目だけを計算する。これなしで同じコマンドを実行すると、フォルダーにある全部をまとめる

## waves
help-waves-about = シーンを計算し、たわむ桁の断面力を時刻と位置に対して描く：波の伝播と反射が見える
help-waves-girder = 桁の名前。省くと最初のたわむ桁
help-waves-force = 描くもの：axial (軸力 N)、shear (せん断力 Q)、moment (曲げモーメント M)、stress (縁応力)。立体では shear_z、moment_y、torque も
help-waves-from = 図の始まりの時刻 [s]。省くと最大の衝突の少し前
help-waves-to = 終わりの時刻 [s]。省くとその衝突から波が数回通過した後
help-waves-out = 図と表のフォルダー

## presets
help-presets-about = プログラムに付属するシーンの一覧

## render
help-render-about = シーンの計算の図を描く
help-render-at = 時刻 [s]、または `peak`：接触力が最大の時刻。何度でも与えられる
help-render-frames = 動画：静止した視点から等間隔にこの数の図、1 から番号を付ける
help-render-marks = 桁と振動台の白い標点を真上から見た動画とその配置、`girderbench measure` 用
help-render-mark_mm = 標点の直径 [mm]。省くと最も狭い桁の幅の 0.08 倍
help-render-rate = 標点の動画の毎秒の図の数 [Hz]
help-render-exposure_ms = 標点の動画の各図の露光時間、その時刻の前後：動くものはぶれる [ms]
help-render-from = 動画の始まりの時刻 [s]
help-render-to = 動画の終わりの時刻 [s]。省くと計算の終わり
help-render-fps = GIF の毎秒の図の数、50 まで：再生の速さ
help-render-view = 視点。省くとシーンの視点。`contact` は最大の衝突を写す
help-render-size = 幅と高さの画素数。省くと 1280x720、--marks では 720x465
help-render-out = フォルダー、1枚の図なら .png、動画なら .gif で終わるファイル
help-render-show = シーンのものに加えて描く層、コンマ区切り
help-render-hide = 描かない層、コンマ区切り
help-render-background = 物体の背景
help-render-quality = 1枚の図にかける手間。`auto` はプロセッサで描くときに減らす
help-render-force_scale = 力の矢印の縮尺 [N per m]。省くと計算の最大値から決める
help-render-bent = たわむ桁を、この倍率で変形させて描く。`auto` は最大のたわみを長さの 3 % に描く
help-render-force = それを断面力で色分けする：axial (軸力 N)、shear (せん断力 Q)、moment (曲げモーメント M)、stress (縁応力)。立体では shear_z、moment_y、torque も
help-render-title = 題名。省くとシーンの名前

## sweep の量
measure-max_rotation = 桁の最大回転角 |θ|
measure-max_displacement = 桁の G の最大変位
measure-max_drift = 桁の隅角部の平面での最大変位
measure-max_force = 接触力 |R_k| の最大値
measure-max_total_force = 2つの物体の間の力の最大：その間の全接触点の合力
measure-max_impulse = 衝突の最大力積。衝撃モデルで
measure-hits = 衝突の数：組の最初の接触点が閉じてから最後が開くまでを1回とする
measure-first_hit = 最初の接触の時刻。接触がなければ空
measure-stick_time = 固着している時間、全接触の和
measure-slip_time = 滑っている時間、全接触の和
measure-least_gap = 向かい合う組の最小の遊間 (面に直角)、接触中は負。組がなければ空
measure-least_seat = 残る桁かかり長の最小値、縁に直角、外れると負。桁かかりがなければ空
measure-unseated = 隅角部が初めて桁かかりから外れた時刻。外れなければ空
measure-max_pier_drift = 橋脚天端の基部に対する変位の最大。橋脚がなければ空
measure-max_pier_shear = 橋脚基部のせん断力の最大。橋脚がなければ空
measure-max_bearing_displacement = 支承の水平変位の最大。支承がなければ空
measure-max_bearing_force = 支承の水平力の最大。支承がなければ空
measure-max_device_force = 装置の力の最大。装置がなければ空
measure-max_stress = たわむ桁の縁応力の最大 (自重による分を除く)。たわむ桁がなければ空
measure-max_overlap = 接触が定義されていない物体の重なりの最大値
measure-estimated_error = 許容誤差を 1/100 とした計算との変位の差の最大値。そのための計算も行う
measure-energy_residual = エネルギー収支の残差、最大エネルギーに対する比
