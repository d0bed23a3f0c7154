# コマンドの表示 (日本語)。キーと値の名前は en.command.ftl と同じ。

## run と check の表示
run-head = { $name }：{ $duration } s のうち { $end } s
run-model = モデル
run-impact = 衝撃 (剛体、力積)
run-outside = 検証範囲外
run-support-lost = 支えの喪失
run-too-deep = 深い食い込み
run-limit = 許容値の超過
run-left-face = 面からの逸脱
run-displacement = 最大変位
run-rotation = 最大回転角
run-force = 最大接触力
run-impulse = 最大力積
run-hits = 衝突
run-stick-slip = 固着と滑りの時間
run-error = 推定誤差
run-ledger = 収支の残差
run-time-taken = 計算時間
run-digest = ダイジェスト
run-overlap = 重なり
run-uplift = 浮き上がり
run-tilt = 最大傾斜角
run-total = 二物体間の力
run-gave-up-at = { $t } s、{ $place }：{ $reason }
run-lifts-at = { $bearing } は { $t } s に反力が 0 となり、浮き上がる
run-damped-at = { $bearing } は { $t } s に反力が 0 となり、浮き上がる。ばねがまだ圧縮中に鉛直ダッシュポットが最大 { $pull } で引く ({ $tp } s)
run-pulls-at = { $bearing } は { $t } s に反力が 0 となり、その後最大 { $pull } で引く ({ $tp } s)：この支承の則に浮き上がりはない
run-total-at = { $force } ({ $t } s)、二物体間の全接触の和
run-pair-returns = 。反発係数の結果 { $returned } (指定 { $asked })
run-pair-total = 、全接触の和は { $total }
run-lost-at = { $bearing }：{ $t } s、({ $x }, { $y }) m。以後の値はこの支承なし
run-pier-yields = 。{ $t } s から降伏、塑性率 { $ductility }。最後に除荷して橋軸 { $along }、直角 { $across } mm 残る
run-pier-numbers = 単独で T 橋軸 { $along } s、直角 { $across } s。変位 { $drift } mm ({ $td } s)、基部せん断力 { $shear } ({ $ts } s){ $yielded }
run-pier = 橋脚 { $name }
run-bearings = 支承 { $girder }
run-bearings-of = 水平変位 { $moved } mm (支承 { $bearing }、{ $t } s)、一つの水平力 { $force } (支承 { $which }、{ $tf } s)
run-overlap-of = { $one } と { $other }、接触なし：{ $t } s から、最大 { $depth } mm ({ $td } s)
run-overlap-more = ほか { $more } 件
run-too-deep-of = { $face } への { $node }：{ $t } s に { $depth } mm、最短辺の十分の一 ({ $allowed } mm) を超える
run-left-face-of = { $count } 回、ばねのエネルギー { $energy } J、最大エネルギーの { $share }。最大は { $t } s に { $face } から { $node }
run-outside-more = 、ほか { $more } 件
run-none-lasting = 続くものなし
run-force-lasting = 単独の隅角部に { $force } (持続)
run-force-at = 単独の隅角部に { $force } ({ $t } s)
run-no-contact = 接触なし
run-impulse-at = { $impulse } N·s ({ $t } s)
run-hits-of = { $hits } 回 (接触点ごとには { $touches } 回)
run-stick-slip-of = { $stick } s、{ $slip } s (全接触の和)
run-pair-of = 摩擦則は{ $law }、接触 { $touches } 回、1点の最大 { $peak }{ $total }
run-pair = 組 { $name }
run-soil-of = { $t } s に { $push } mm 押され { $force }、終局抵抗力の { $share } %。{ $gap } mm の隙間が残る
run-soil = 背面土 { $name }
run-unbalanced = {" "}(許容値を超える)
run-error-of = { $error } (許容誤差 { $tolerance } の 1/100 の計算と比べて)
run-error-not = 求めていない
run-ledger-of = { $residual } J、最大エネルギーの { $share }{ $unbalanced }
run-time-of = { $time } s、実時間の { $times } 倍
run-seat = 桁かかり { $girder }{ $end }
run-seat-lost = 桁端全体が { $t } s から外れる
run-seat-along = {" "}(橋軸方向 { $length })
run-seat-at = {" "}({ $which })
run-seat-of = 初期 { $placed } mm{ $along }、最小 { $least }{ $corner }、移動量 { $used }、{ $t } s
run-corner = 隅角部 { $corner } ({ $angle })
run-corner-off = { $which }が { $t } s に外れる、縁に沿って { $at } m。最小でも端の幅の { $share } % が載っている
run-corner-side = { $which }が { $t } s に側方へ外れる
run-needed = 必要
run-there = 現況
run-used = 移動量
run-seats-head = 桁かかり (縁に直角) [mm]
run-seats-legend = * 記憶による引用、その版では未確認。° 仮定の入力を含む、summary.json の codes
run-seats-turned = G まわりの回転で桁かかりがなくなる角：{ $one }の隅角部 { $first }°、{ $other }の隅角部 { $second }°、中央 { $middle }°
run-polynomials = 多項式
run-flexible = 弾性 { $girder }
run-flexible-rigid = 弾性分は { $tol } 未満 (κ_e = { $kappa })：剛体
run-flexible-of = κ = { $kappa }、κ_e = { $kappae }、次数 { $degree }、{ $count } モード { $frequencies } Hz から、a₀/c = { $transit } ms
run-strength-of = { $strength } MPa を超える：そこではもう弾性ではない
run-strength = 強度
run-left-out = 省略した項
run-warning = 警告
run-hardest = 最大の衝突
run-not-negligible = 無視できない：{ $names }
run-returned = 、重心の反発係数 e = { $e }
run-hit-of = { $t } s、接触 { $time } ms{ $restitution }。直後のモードのエネルギー { $ringing } J
run-hit-goes-on = { $t } s から計算の終わりまで { $time } ms：まだ終わっていない。モードのエネルギー { $ringing } J
run-section-forces = 中央の |N| 最大 { $axial } MN ({ $t } s、ひずみの差 { $difference })、|M| 最大 { $moment } MN·m{ $in_space }。縁応力 最大 { $stress } MPa (s = { $s } m)
run-section-forces-space = 、|M_y| 最大 { $moment } MN·m、|T| 最大 { $torque } MN·m
run-degrees = 次数 { $one } と { $other }：力 { $force }、力積 { $impulse }、端 { $ends }、中央の N { $section }、モーメント { $moments }
warning = 警告：{ $what }
warning-more-outside = 警告：ほか { $more } 件が検証範囲外
note = 注記：{ $words }
warning-untrusted = この結果を信用しない：ほかの警告に従うか、solver.tolerance を下げる
warning-balance = 警告：{ $name }：{ $balance }：{ $remedy }
failed-gave-up = { $scene } の計算は t = { $t } s で{ $ended }、{ $place }：{ $reason }
failed-interrupted = 中断：{ $kept }
failed = エラー：{ $failure }
failed-no-pictures = このビルドは図を描けない：`cargo build --release --features render` でビルドする
failed-standard-output = 標準出力：結果を書けない ({ $error })：空きのある所へ向ける
run-removed = 前の結果から削除：{ $names }
run-written = { $folder } に書いた：{ $names }
failed-cells = --sample：{ $samplehz }：{ $table } は { $cells } 個の値となり { $most } を超える：毎秒 { $less } 行以下とするか、計算を短くする
failed-trajectory = 軌跡の表
report-written-to = { $file } に書いた
open-headless = { $why }：代わりに図と表を { $folder } に書く
open-no-window = このビルドには画面がない (gui 機能)
failed-threads = --threads { $count }：始められない ({ $error })：少なくする
wrong-out-before = コマンドの前に --out がある：そのコマンドに --out があれば後に書く
mistake-of = { $what }：{ $subject }
wrong-one-of = 次のどれかを与える：{ $words }
wrong-no-number = 数を与える
wrong-no-count = 1 以上の整数を与える
wrong-not-above = 0 より大きい数を与える
wrong-below = 0 以上の数を与える
warning-unjoined = 警告：{ $one } と { $other }：初期の間隔 { $apart } mm、接触なしに { $reach } mm まで動く：両者の間に接触が定義されていないので、通り抜けうる。[contact] に `between = "all"` を与える (接触モデル)、離して置く、硬く支える、または `girderbench run` の summary の `overlap` を見る
warning-more-unjoined = 警告：このような組がほか { $more } 件
check-touch-anywhere = 物体は出会う所で接触する
check-touch-nowhere = 接触しうるものはない
check-impact = 衝撃モデル：e_n = { $en }、e_t = { $et }、面の μ_s = { $mus }、μ_k = { $muk }、隅の μ̄_s = { $cmus }、μ̄_k = { $cmuk }
check-impact-differs = 二つのモデルの継目が異なる：[impact] の e_n = { $impact }、[contact] の e_n = { $contact }
check-no-pairs = 向かい合う端なし：{ $elsewhere }
check-assumed = 仮定：{ $path } = { $value }
check-planar = 平面
check-spatial = 立体、重力加速度 { $gravity } m/s²
check-head = { $name }：{ $kind }、{ $duration } s
check-head-b = 地動：{ $motion }
check-named-ground = 地動「{ $name }」：{ $motion }
check-unused-ground = 地動「{ $name }」 (この地動に載るものはなく、何も動かしません)：{ $motion }
check-head-c = 解法：{ $method }、許容誤差 { $tolerance }
check-head-d = 視点：{ $camera }
check-assumed-stiffness = 数値が与えられない組の K：桁の E A / L、A = width_m × thickness_m、L = a₀。弾性桁では桁自身の E と A、L = a₀/10 (仮定)
check-pair = 組 { $pair }：遊間 { $gap } mm (橋軸方向)、摩擦則は{ $law }、剛性は{ $sharing }、引張は{ $tension }
check-pair-gap = 組 { $pair }：遊間 { $gap } mm (橋軸方向)
check-nodes = 節点：{ $nodes }
check-normal-law = 法線則 { $law }、較正 { $calibration }：{ $speed } m/s の自由な正面衝突は e = { $e } を返す
check-node = { $face } への { $node }
check-girder-place = 位置 { $place } m、方位 { $heading }°
check-girder = 桁 { $name }：{ $length } × { $width } × { $thickness } m、{ $mass } kg、β = { $skew }° (米国式斜角 { $complement }°)、i = { $gyration } m
check-tilted = 、縦傾斜 { $pitch }° ({ $pitchrate }°/s)、横傾斜 { $roll }° ({ $rollrate }°/s)
check-starts = 初期変位 { $place } m、回転 { $turn }°、速度 { $velocity } m/s、{ $spin }°/s{ $tilted }
check-pushed = 外力 { $force } N、{ $moments } N·m
check-held = 拘束：{ $ways }
check-seat = { $end } 端 { $length } m
check-seat-wider = 、桁の両側より { $side } m 広い
check-seats = 桁かかり：{ $given }{ $wider }
check-no-bearings = 支承なし
check-bearings = 支承 { $count } 個：ω_x, ω_y, ω_θ = { $omega } rad/s ({ $hertz } Hz)、h_x, h_y, h_θ = { $damping }
check-bearings-b = 偏心：剛性 ε_x, ε_y = { $stiffness }、ダッシュポット η_x, η_y = { $dashpots }
check-density = 質量は寸法に対して { $density } kg/m³ (コンクリート 2500、鋼 7850)：mass_kg の単位は kg か
check-in-dish = 支承 { $number } は静止時の { $part } 倍の荷重で始まる：この水平変位で球面に沿い { $rise } m 上がるが、displacement_m の鉛直成分はそうでない
check-tips = 支承は桁を直立に保てない (重心の片側にあるか、一直線に近い)：自由になると傾いて転倒する
check-pulled = 支承 { $number } は静止時に { $pull } kN で引かれ、桁を押さえている
check-vertical = 鉛直：ω_z = { $omega } rad/s ({ $hertz } Hz)、h_z = { $ratio }
check-can-rotate = 回転しうる
check-cannot-rotate = 自らは回転しない
check-condition = 条件 (6)：a0 sin 2β / (2 b0) = { $number }：{ $can }
check-yield = うち { $count } 個が降伏：Q = { $force } N、降伏前の k_x, k_y = { $x }, { $y } N/m。振動数は降伏後の値
check-flat = 平ら
check-slide = うち { $count } 個がすべり：μ = { $friction }、{ $radius } (最初のもの)、{ $displacement } m で摩擦が全て現れる。N は鉛直力に従い、振動数は N/R を除く
check-assumed-of = 。仮定：{ $numbers }
check-then-drops = 隅角部が { $drop } m 落ちたら計算を止める
check-then-stops = そこで計算を止める
check-then-goes-on = その支承なしに計算を続け、その旨を示す
check-rooms = うち { $count } 個は支えを失いうる、最初は桁端に直角に { $least } m：{ $then }
moved-own-ground = 「{ $ground }」、
moved-support = { $name }：{ $ground }{ $delay } s 遅れ、× { $factor }。基準の地盤から最大 { $largest } m、最後に { $last } m
check-moving = 支点の地盤 { $moved }
run-ground-under = 支点の地盤
check-on-piers = うち { $count } 個は { $piers } の上。振動数は橋脚が動かないときの値
check-on-abutments = うち { $count } 個は { $abutments } の上
check-flexible-rigid = 剛体：弾性分は { $tol } 未満
check-flexible-degree = 次数 { $degree }、{ $count } モード、{ $frequencies } Hz から
check-flexible-twice = K は E A / a₀ に近い：桁自身のたわみ性 (64) を表す値なら二重になる
check-flexible = 弾性 { $name }：A = { $area } m²、I_z = { $second } m⁴、E A = { $axial } N、E I_z = { $bending } N·m²、k_s G A = { $shear } N
check-flexible-space = I_y = { $second } m⁴、J_t = { $constant } m⁴、E I_y = { $bending } N·m²、G J_t = { $torsion } N·m²
check-flexible-b = c = { $speed } m/s、a₀/c = { $transit } ms、κ = { $kappa }、κ_e = { $kappae }：{ $degree }{ $twice }
check-ground = 地盤
check-device = { $kind } { $name }：{ $girder } の { $first } m と { $to } の { $second } m、距離 { $length } m
check-cable = { $slack } mm で張る、K = { $stiffness } N/m
check-cable-yields = 、{ $force } N で降伏 (さらに { $at } mm)、その後 K₂ = { $after } N/m
check-cable-breaks = 、さらに { $elongation } mm で破断 ({ $force } N)
check-bumper-point = { $depth } mm で { $force } N
check-bumper = { $normal } の向きに押す、{ $gap } mm から。{ $lines }、c = { $damping } N·s/m
check-brace = 直列の K_b = { $brace } N/m
check-regularised = { $speed } m/s で正則化
check-linear = 線形
check-damper = F = { $c } |v|^{ $alpha } N：0.1 m/s で { $slow } N、1 m/s で { $fast } N。{ $form }
check-stop-breaks = 、{ $force } N ({ $at } mm) で破断
check-stop-yields = 、{ $force } N ({ $at } mm) で降伏
check-stop-yields-breaks = 、{ $force } N ({ $at } mm) で降伏、さらに { $after } mm で破断
check-stopper = { $along } の向きの { $sides } mm で止める、K = { $stiffness } N/m{ $fails }
run-device = { $kind } { $name }
run-device-never = 力が働かない
run-device-part = {" "}(強度の { $part } %)
run-device-yields = 。{ $t } s から降伏
run-device-breaks = 。{ $t } s に破断
run-device-of = { $force } ({ $t } s){ $part }。変位 { $least } ～ { $greatest } mm、{ $first } s から { $times } 回働く{ $yields }{ $breaks }
kind-restrainer = 落橋防止ケーブル
kind-bumper = 緩衝ゴム
kind-damper = ダンパー
kind-stopper = 変位制限構造

## ほかのコマンドの表示と誤り
wrong-bent = 0 から 1e6 までの数、または auto を与える
wrong-size = 幅x高さを与える。それぞれ 16 から 16384 まで。例：1280x720
wrong-instant = 0 s 以後の時刻、または peak を与える
wrong-frame-rate = 毎秒の図の数を 0.1 から { $most } までとする
wrong-film-backwards = --to { $to }：動画は { $from } s に始まる：それより後の時刻を与える
wrong-one-file = --out { $out }：{ $count } 枚の図に1つのファイル：フォルダーを与える
wrong-marks-view = --view { $view }：標点は真上から見る：外すか、top を与える
wrong-marks-file = --out { $out }：--marks は番号付きの図と marks.toml を書く：フォルダーを与える
wrong-report-format = --out { $out }：報告書は1つの HTML ファイル：.html で終わる名前を与える
wrong-picture-format = --out { $out }：形式 .{ $format } の図は書けない：1枚の図なら .png、動画なら .gif で終わるファイル、またはフォルダーを与える
wrong-gif-frames = --out { $out }：GIF は動画：--frames で図の数を与える
wrong-gif-background = --background transparent：GIF の動画では使えない：ほかの背景にするか、PNG の図のフォルダーを与える
wrong-after-end = { $flag } { $t }：計算は { $end } s に終わる：0 から { $end } までの時刻を与える
wrong-until-varied = --until：各計算の長さは --vary duration_s が決める。どちらか一方を除く
wrong-mark-mm = --mark-mm { $mm }：小さすぎる標点は写らず、大きすぎると重なる：{ $least } から { $most } とする
wrong-exposure = --exposure-ms { $ms }：図の間隔は { $most } ms：それ以下とする
wrong-rate = --rate { $rate }：図が { $count } 枚になる：{ $most } 枚より少なくする
render-marks = { $file }：標点 { $count } 個、1画素 { $scale } mm
note-no-peak = この計算では接触がない：`--at peak` は始まりを写す
render-finished-pictures = { $count } 枚のうち { $finished } 枚が { $place } にできている
render-finished-frames = { $count } 枚のうち { $finished } 枚が { $place } にできている
render-frames = { $place }：{ $count } 枚、うち異なる図 { $drawn } 枚
wrong-no-quantity = { $name }：計算にその名前の量はない{ $meant }。`--list` で全ての名前を表示する
wrong-girder-flag = --girder { $name }：その名前の桁はない：あるもの：{ $names }
wrong-no-wave = たわむ桁がなく、波も伝わらない：[girder.elastic] と、それで軟らかくなるほど硬い接触を与える
wrong-force-in-space = { $force } は立体シーンの断面力。kind = "spatial" とするか、ほかの断面力を指定する
wrong-picture-backwards = --to { $to }：図は { $from } s に始まる：それより後の時刻を与える
wrong-no-from = --to だけで --from がない：図の始まりを与える
waves-largest = { $what }：{ $times } 時刻、{ $stations } 断面のうち最大 { $largest }
wrong-journal-busy = 別のプロセスが書いている：終わるのを待つか、別の --out を与える
wrong-journal-other = 別のスイープの記録：別の --out を与えるか、これを削除する
wrong-journal-changed = 解法か量がこれらの行のものと異なる：別の --out を与えるか、記録を削除して全て計算し直す
warning-journal = 警告：{ $file }：壊れた { $damaged } 行を除き、その計算をやり直す
sweep-by-version = プログラムの版
sweep-by-scene = シーン
sweep-by-records = 地震動の記録
sweep-changed = 変更されている
sweep-another = 別のスイープ (異なるもの：{ $parts })
wrong-sweep-folder = { $file }：{ $found }：別の --out を与えるか、始めたときのシーン、--vary、--measure を与える
sweep-runs = 計算 { $runs } 個、うち未計算 { $missing } 個
sweep-part = この部分は終わった。全ての部分が終わったら、--shard なしの同じコマンドでデータセットを書く
sweep-ended = 計算 { $count } 個が { $how }：{ $run } 番：{ $reason }
sweep-digest = データセット { $digest }
wrong-record-twice = { $name }：同じ名前の記録が2つある：それぞれに --out を与える
motion-file = { $file }：{ $format }、{ $count } 成分
motion-unstated = 方向の記述なし
motion-azimuth = 方位角 { $azimuth }°
motion-up = 上向き
motion-spectrum-title = { $record }：応答スペクトル、減衰 5 %
motion-no-name = 名前なし
motion-nothing = なし
motion-channel = 成分 { $number }：{ $name }、{ $direction }
motion-samples = 単位 { $unit }：{ $count } 点、{ $dt } s 間隔、{ $length } s
motion-peak = 最大加速度 { $g } g = { $gal } gal ({ $t } s)
motion-ground = 最大速度 { $velocity } m/s ({ $tv } s)、最大変位 { $displacement } m ({ $td } s)：静止から積分、データの間は直線
motion-strong = 強震継続時間 { $duration } s、{ $from } ～ { $until } s：アリアス強度 { $arias } m/s の 5 ～ 95 % (有意継続時間)
motion-done = 処理：{ $done }
wrong-scaled = --scaled：--scene か --record で地動を与える
wrong-no-girder-flag = --girder：次のどれかを与える：{ $names }
wrong-shard = I/N を与える：N 個に分けた I 番目。1/8 から 8/8 のように
wrong-nothing-common = { $a } と { $b }：共通の時刻 { $instants }、共通の量 { $quantities }：両方に同じ物体と --sample を与える
wrong-both-read = { $flags }：{ $a } と { $b } は結果のフォルダーで、読むだけで計算しない：これを外すか、シーンを与える
note-no-pictures = 図なし：{ $why }
sweep-measures = 量とその単位：
sweep-outside = { $runs } 件の計算のうち { $count } 件で、例：{ $first }
sweep-refused = 拒否

## compare、identify、measure、study の表示
compare-instants = 両方にある時刻 { $count } 個
compare-until = { $which } は { $t } s で終わる。もう一方のそれ以後は比べない
compare-instants-only = 両方にある時刻 { $count } 個、一方だけの時刻 { $others } 個
compare-quantity = 量
compare-difference = 差
compare-at = 時刻 t [s]
compare-largest = 最大値
compare-parts = 最大値の { $within } を超えて分かれる時刻
compare-never = なし
compare-only = { $which } だけにある：{ $names }
compare-events = イベント：A に { $a } 個、B に { $b } 個
compare-same-events = { $count } 箇所の接触で同じイベントが同じ順に起こる、時刻の差は { $apart } s 以内
compare-event = { $contact }：A { $a }、B { $b }
compare-no-more = それ以上なし
compare-event-at = { $t } s に { $kind }
compare-part-motion = { $name }、最大値の { $within } を超える差
compare-part-events = { $contact } のイベント
compare-part = t = { $t } s で分かれる：{ $what }
compare-agree = 各量の最大値の { $apart } まで一致する
identify-rows = { $file }：{ $count } 行{ $name }、{ $from } ～ { $to } { $unit }、変位の単位 { $in }
identify-of = {" "}({ $name })
identify-ground = 地動
identify-resonance = 共振
identify-resonance-of = { $frequency } Hz (探索の出発点)
identify-as-given = {" "}(与えた値)
identify-residual = 残差
identify-residual-of = RMS { $rms } mm、動きの { $share } %
identify-interval = ± は 1 自由度系で真値を 100 回に 95 回含む区間の半幅
identify-at-bound = h は探索の上限にある：ほとんど振動せず、f も h もその区間も信頼できない
identify-poor = 1 自由度系と異なる動き：区間に意味はない (衝突、滑り、別の地動？)
identify-independent = 行ごとに独立
identify-correlated = 行間の相関 { $next } ({ $order } 次の自己回帰)、区間はこれを考慮
identify-still = 静止：自由減衰
identify-sines = 加速度一定の正弦波
identify-shaken = { $scene } の地動、{ $angle }° 方向に { $peak } g
identify-no-shaking = { $scene }：地盤は { $angle }° 方向に動かない
identify-touches = 警告：{ $scene }：このシーン自身の計算では { $pair } が { $t } s から接触するが、1 自由度系は接触しない：それより前の行を使う (--to) か、--fit でシーンの値を求める
identify-frequency = 固有振動数 f
identify-damping = 減衰定数 h
identify-displacement = 初期変位
identify-velocity = 初期速度
identify-zero = 目盛の零点
identify-factor = 地動の倍率
identify-amplitude = 地動の振幅
identify-too-few = 求めた時間内に { $have } 行：{ $need } 行以上を与える
identify-no-motion = 変位がすべて同じ：動く時刻歴を与える
identify-undetermined = f と h が現れない：もっと長い時刻歴、動いている間に始まり増大しない時刻歴、または応答の元の地動を与える
fit-key = KEY=START を与える
fit-number = START は数とする
fit-not-zero = START は 0 でない数とする
fit-rows = { $file }：{ $girder } の { $axes }、{ $rows } 行
fit-both = x と y
fit-runs = 計算
fit-model = { $scene }、モデル "{ $model }"
fit-residual = RMS { $rms } mm、動きの { $share } %、{ $noise }
fit-correlated = 行間に相関 ({ $order } 次の自己回帰)
fit-outside = { $file }：{ $last } s まで { $have } 行：計算の { $end } s 以内に { $least } 行以上を与える
fit-start = { $values } ではシーンを計算できない：{ $why }
fit-undetermined = { $keys } は計測値に現れないか、区別できない：1つ外すか、もっと計測する (摩擦は y に現れる)
fit-ended = 計算が { $t } s で終わる、{ $reason }：別の値から始める
fit-too-short = 計算は { $end } s、計測は { $last } s で終わる：--set duration_s={ $last }、または --to { $end }
wrong-brightness = 0 以上 255 未満の数を与える
measure-no-text = 文字でない：UTF-8 で書く
measure-dark = 背景から際立つものがない：明るい標点とするか、--threshold を与える
measure-count = { $least } 画素以上の標点が { $count } 個：--threshold か --least-pixels を変える
measure-picture = { $number } 枚目
measure-film = { $folder }：{ $width } × { $height } の画像 { $count } 枚、{ $from } s から毎秒 { $fps } 枚
measure-marks = 明るさ { $threshold } を超える標点 { $marks } 個、1 画素 { $scale } mm
measure-range = { $low } ～ { $high }
measure-one-mark = 標点が1つ：θ なし
measure-extent = { $body }：最初の画像から x { $x } mm、y { $y } mm、{ $rotation }
measure-against = { $name } と計算の差：RMS { $rmspx } 画素 = { $rms } mm、最大 { $largestpx } 画素 = { $largest } mm ({ $t } s)
measure-against-turn = θ と計算の差：RMS { $rms }°、最大 { $largest }° ({ $t } s)
measure-too-few = 配置の指定は画像 { $count } 枚、実際は { $have } 枚：描き直すか、指定を直す
measure-no-pictures = PNG 画像がない：画像のあるフォルダーを与える
measure-hole = { $before } の次が { $after }。画像はすべて次の時刻とみなす：欠けた画像を置くか、画像自体を並べて与える
measure-pixels = { $width } × { $height } 画素：{ $most } 画素以下の画像を与える
measure-no-picture = 読める PNG 画像でない ({ $error })：保存し直すか、外す
measure-depth = 読めない色深度：1 チャンネル 8 ビットとする
measure-no-body = 物体 { $body } がない：標点を { $names } のどれかに付ける
measure-short = 計算は { $end } s、動画は { $last } s で終わる：計算を延ばすか、from_s か fps を直す
layout-line = { $line } 行目：{ $what }
layout-fps = fps { $fps }：毎秒の枚数を 0 より大きく与える
layout-from = from_s { $from }：時刻を s で与える
layout-scale = mm_per_pixel：0 より大きい長さを与える
layout-many = 標点 { $count } 個：{ $most } 個以下とする
layout-body = body：1 ～ 60 文字で1行の名前を与える
layout-none = 標点がない：body と pixel をもつ [[mark]] を与える
layout-finite = pixel と at_mm は有限の数とする
layout-table = 標点がすべて { $table } にある：物体の標点を与える
layout-no-scale = 縮尺がない：mm_per_pixel (--mm-per-pixel) か、table または1つの物体の2標点の at_mm を与える
mark-missing = 標点 { $mark } ({ $body }) がない：({ $x }, { $y }) から { $within } 画素以内に明るいものがない
mark-merged = 標点 { $one } と { $other } が ({ $x }, { $y }) で1つになった
mark-grown = 標点 { $mark } ({ $body }) が ({ $x }, { $y }) で明るいものとつながった：{ $area } 画素、最初は { $first } 画素
mark-shrunk = 標点 { $mark } ({ $body }) が ({ $x }, { $y }) で一部隠れた：{ $area } 画素、最初は { $first } 画素
mark-at-edge = 標点 { $mark } ({ $body }) が ({ $x }, { $y }) で画像の端に達した
mark-size = { $width } × { $height } 画素、最初の画像は { $firstwidth } × { $firstheight } 画素：同じ大きさの画像を与える
study-written = { $folder } に書いた：{ $count } ファイル
study-none-of = { $flag }："{ $name }" は { $known } のどれでもない：この中から与える
study-computed = 計算 { $run } 個、既存 { $there } 個。{ $page }
study-seed = 種 { $seed } ({ $family })：{ $check }：{ $detail }
study-seeds = 種 { $seeds } 個：検証範囲内 { $inside } 個、うち失敗 { $failedinside } 個。範囲外 { $outside } 個、うち失敗 { $failedoutside } 個。{ $folder } に書いた
study-failed = 種 { $seeds } 個のうち { $failed } 個が失敗：{ $page } に再現するコマンドとともに示す
wrong-measure = その名前の量はない{ $meant }。量：{ $names }
progress-of = { $whole } { $unit }中 { $reached }{ $words }
progress-left = 残り { $left }
progress-seconds = s
progress-runs = 回
progress-pictures = 枚
progress-results = 個
progress-seeds = 個
progress-error = 誤差を推定中：許容誤差 1/100 の計算
warning-drift = 警告：{ $words }
warning-more-drift = 警告：そのような支点がほかに { $more } 箇所
interrupted-nothing = 何も書いていない
progress-again = 、出会った物体の接触を加えて再計算
headless-no-render = このビルドは図を描けない (feature render)

gpu-without = { $name }={ $value } がある：外して試す。
gpu-install-mesa = mesa-vulkan-drivers (または libegl1 と libgl1-mesa-dri) を入れる
gpu-install-driver = 描画装置のドライバーを入れる
