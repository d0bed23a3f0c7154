# シーンの誤りと直し方 (日本語)。キーと値の名前は en.complaints.ftl と同じ。

## 指摘の一行
complaint = { $file }：{ $place }：{ $value }。{ $remedy }

## 範囲外の数
wrong-not-finite = 有限の数とする：{ $remedy }
wrong-extreme = 1e-15 から 1e15 までの数を与える
wrong-not-positive = 0 より大きい数を与える
wrong-too-large = 1e15 以下の数を与える
wrong-negative = 0 以上の数を与える
wrong-outside = { $low } から { $high } までの数を与える
wrong-not-between = { $low } と { $high } の間の数を与える (両端を除く)
wrong-not-plain = 1e15 以下の普通の数を与える

## シーン
found-both = { $one } と { $other }
found-nothing = なし
wrong-both = どちらか一方を与える
wrong-foreign = 種類 { $kind } の支承にはない。外す
found-number = 数
wrong-ratio-below-one = 1 より大きい値を与える：降伏前の方が硬い
wrong-radius-and-period = どちらか一方を与える：T = 2π √(R/g)
found-gravity = 重力加速度 { $gravity } m/s²
wrong-weightless = 力は重量で決まる。gravity_m_s2 を与える
wrong-no-vertical-frequency = 立体シーンの桁は支承で支える。鉛直の振動数を Hz で与える
wrong-no-places = 支承の位置を与える：at_m = [[x, y], …]、または at_skewed_m
wrong-empty-places = 位置 [x, y] を1つ以上与えるか、`bearings` を外す
wrong-no-bearing = 支承を1つ以上与えるか、`bearings` を外す
wrong-no-vertical-stiffness = 立体シーンの桁は支承で支える。3つ目 (鉛直) の数を与える
wrong-no-yield-displacement = 支承が降伏する変位を m で与える
wrong-no-yield-force = 力 Q を N で与えるか、両方とも外す
found-switch = 切替え
complaints-more = ほか { $more } 件
wrong-per-axis-slider = これを外す：すべり支承の摩擦はどの方向にも同じ
wrong-per-axis-alone = yield_force_n と yield_displacement_m を与えるか、これを外す
wrong-friction-missing = `friction` も与えるか、これを外す
wrong-slider-in-space = 立体のすべり支承は鉛直力で決まる。3つ目 (鉛直) の剛性を与える
found-loads = 合計 { $sum } N
wrong-loads = 静止時の反力の和は桁の重量 { $weight } N に等しくする
found-loads-at = G から [{ $x }, { $y }] m に働く反力
wrong-loads-turn = 摩擦は、桁を G まわりのモーメントなしに支える反力で決まる。支承を G のまわりに置くか、各々に load_n を与える
found-all-loads = 反力
wrong-loads-in-space = 立体シーンでは鉛直剛性から決まる。load_n を外す
found-some-loads = 一部の反力
wrong-some-loads = すべり支承を含む全ての支承に load_n を与えるか、全く与えない
found-bearing-off-seat = 支承 { $number } は初期配置で桁かかりの前縁の外
wrong-bearing-off-seat = 桁かかりの上に置くか、桁かかりを長くするか、after_unseating を外す
wrong-vertical-in-plan = 平面シーンに鉛直はない。2つの数を与えるか、kind = "spatial" とする
found-ends = { $skew }° の { $width } m × { $thickness } m の端
wrong-ends = この端からは面が計算できない。寸法と斜角をもっと普通の値にする
found-device-far = 最も遠い隅角部の { $far } 倍 G から離れた点
found-bearing-far = 最も遠い隅角部の { $far } 倍 G から離れた支承
wrong-device-far = そこに桁はない。位置を G から m で与える
wrong-bearing-far = その位置の支承は桁を支えない。位置を G から m で与える
wrong-fuse-force-missing = fuse_force_n も与えるか、どちらも与えない
wrong-fuse-stiffness-missing = fuse_stiffness_n_per_m も与えるか、どちらも与えない
wrong-no-face = gap_m を与えるか、面の隅を polygon_m で与える
found-corners = 隅 { $count } 個
wrong-corners = 4つの隅 [x, y, z] を与える
wrong-beside-polygon = polygon_m で決まっている。これを外す
wrong-in-plan = 平面シーンに鉛直、ロール、ピッチはない。外すか、kind = "spatial" とする
wrong-order = { $name } = { $most } を超えない値にする。これを下げるか、{ $name } を上げる
wrong-format = このプログラムが読む形式は { $version }
wrong-no-name = シーンに名前を付ける
wrong-no-girder = シーンには桁が1つ以上要る。[[girder]] を加える
wrong-bilinear = バイリニアばねは e_n = { $least } 以下では降伏後の剛性がない。もっと大きくするか、別の normal_law とする
wrong-law-parameter = 正面衝突が e = { $least } より小さい値を返すか、離れない。小さくする
wrong-impact-in-space = 衝撃モデルは平面シーンだけを扱う。"contact" とするか、kind = "planar" とする
wrong-impact-elastic = 衝撃モデルは剛な桁だけを扱う。"contact" とするか、[girder.elastic] を外す
found-model-elastic = "{ $model }" と弾性の桁 { $girder }
wrong-impact-wave = 衝撃モデルは一様に動く地盤だけを扱う。"contact" とするか、[wave]、ground、delay_s、motion_factor を外す
found-model-links = "{ $model }" と { $name }
wrong-impact-links = 衝撃モデルは装置、橋脚、降伏・滑りのある支承、支持を失う支承、動く胸壁を扱わない。"contact" とするか、それらを外す
found-model-wave = 一様に動かない地盤での "{ $model }"
found-foot-wave = 上下にも基準と異なって動く橋脚の下端
wrong-foot-wave = 橋脚は平面内だけで動く。地動の上下成分か、地盤の動きの違いを外す
found-slider-wave = 基準と異なって動く地盤の上のすべり支承
wrong-slider-wave = 立体のすべり支承は基準の地盤に立つ自身のばねの力で決まる。平面シーンとするか、ほかの支承とする
wrong-stiffness-twice = K = E A / L は young_modulus_pa、area_m2、contact_length_m から決まる。それらか stiffness_n_per_m の一方を与える
wrong-no-amplitude = 振幅を与える：amplitude_g、または amplitude_m_s2
wrong-no-such-girder = その名前の桁はない。{ $names }
wrong-one-girder = 両方の点が同じ桁にある。別の物体を指定するか、外して地盤とする
wrong-device-on-pier = これは橋脚である。装置がつなぐのは桁、橋台、地盤。外すと地盤となる。{ $names }
wrong-no-such-body = その名前の物体はない。外すと地盤となる。{ $names }
wrong-pier-bears-nothing = この橋脚に立つ支承がない。桁の支承 (on_plus_x, on_minus_x, on) で指定するか、位置 [x, y] を与える
wrong-pier-no-stiffness = N/m で与えるか、frequency_hz、または column_m と height_m を与える
wrong-same-thing = 1つだけ与える。同じことを表す
wrong-no-column-height = k = 3EI/h³ に要る。柱の高さを m で与える
found-modulus = 弾性係数
wrong-column-missing = column_m に伴う値。それを与えるか、これを外す
wrong-not-whole = 整数を与える
wrong-yield-force-missing = yield_force_n に伴う値。それを与えるか、これを外す
wrong-turn-stiffness-missing = turn_stiffness_n_m_per_rad に伴う値。それを与えるか、これを外す
wrong-slider-on-pier = 立体のすべり支承は地盤に立つ自身のばねの力で決まる。地盤に置くか、平面シーンとする
found-slider-on-pier = 橋脚の上のすべり支承
wrong-no-pier = シーンに橋脚がない：[[pier]] を加える
wrong-piers = あるのは { $names }
wrong-no-ground = シーンに地動がない：[[ground]] を加える
wrong-no-such-ground = その名前の地動はない。{ $known }。外すと [motion] となる
wrong-no-such-pier = その名前の橋脚も橋台もない。{ $known }。外すと地盤となる
wrong-nameless = 名前を付ける
wrong-name = 表と --set で区別できない。文字、数字、- と _、間の1つの空白だけを使う
wrong-ground-twice = 同じ名前の地動がある。地動の名前はそれぞれ異なるものとする
wrong-name-taken = グラフでは地盤とエネルギー収支が、測定では振動台がこの名前：別の名前を付ける
wrong-name-twice = 同じ名前の物体か装置がある。桁、橋台、橋脚、装置の名前はそれぞれ異なるものとする
wrong-pair-friction = { $pair } で有効な mu_static { $mus } を超える。これを下げるか、mu_static を上げる
wrong-face = 接触面にならない：{ $error }
wrong-leaning-face = 平面の桁は傾いた面を滑り上がれない。面を鉛直にするか、kind = "spatial" とする
wrong-face-away = { $girder } に背を向けている。そこから見て反時計回りに隅を並べる
found-leaning-backwall = 傾いた胸壁
wrong-leaning-backwall = 動く胸壁は鉛直。面を鉛直にするか、backfill を外す
wrong-soil-never-fails = 終局抵抗力 { $force } N に { $push } m で達しない。どちらかを上げる
wrong-soil-unloads = 土の除荷は載荷より軟らかくならない。{ $stiffness } 以上を与える
wrong-plan-height = 平面のシーンは全部の物体を通る1つの高さで切る。ほかは { $low } から { $high } m にある：z をその間にするか、kind = "spatial" とする
found-heights = { $low } から { $high } m
wrong-overlap = { $one } が { $other } に { $depth } m 食い込む。離す
found-girder = 桁 { $name }
found-abutment = 橋台 { $name }
wrong-azimuth-of-one = [[motion.component]] に伴う値。1成分なら angle_deg を与える
wrong-no-record = samples_m_s2 と dt_s を与えるか、file を与える
wrong-no-interval = 時間刻みを秒で与える
wrong-of-a-file = file に伴う値。外す
wrong-not-loaded = この記録は読まれていない。シーンのファイルとともに読み込む
found-samples = データ { $count } 個
wrong-too-few-samples = 記録には2個以上のデータが要る
found-component-beside = 並ぶ component
wrong-of-one-component = 1成分の記録の値。[[motion.component]] に書くか、そちらを外す
wrong-too-many-components = 地震動の成分は3つまで
wrong-intervals-differ = 成分の時間刻みは等しくする。最初の成分は { $first } s。揃える
found-upward = 上向きの成分
wrong-upward-in-plan = 平面シーンに鉛直はない。外すか、kind = "spatial" とする
found-no-azimuth = 全体座標 x の方位角なし
wrong-no-x-azimuth = [motion] に x_azimuth_deg を与える。成分はそれに対して向く
wrong-no-direction = ファイルに方向がない。azimuth_deg、または vertical = true を与える
wrong-points-too-near = ケーブルとダンパーには 1e-6 m 以上の長さが要る。初期の at_m からそれだけ離れた to_m を与える
found-points-too-near = 2点の距離 { $length } m
wrong-no-vector = 長さのあるベクトルを与える：[1, 0] は橋軸方向、[0, 1] は直角方向
wrong-bumper-no-stiffness = N/m で与えるか、表 depth_force_m_n を与える
wrong-points-coincide = 2点が重なる。normal か、別の to_m を与える
wrong-bumper-behind = 初期配置で at_m は to_m を通る面の後ろにある。法線を逆にするか、点を動かすか、gap_m を与える
found-distance = 法線方向の距離 { $gap } m
wrong-depths = 深さと力は (0, 0) から行ごとに増えるものとする
wrong-no-depths = [深さ, 力] を1つ以上与える
wrong-cable-no-stiffness = K を N/m で与えるか、EA を axial_stiffness_n で与える
wrong-axial-stiffness-missing = axial_stiffness_n に伴う値。それを与えるか、これを外す
wrong-post-yield = K = { $before } N/m より小さくする。下げるか、yield_force_n を外す
wrong-brittle-and-ductile = 脆性の側は break_force_n、延性の側は yield_force_n。どちらか一方を与える
wrong-breaks-before-yield = T_y/K = { $yields } m で降伏する。それより大きい値にする。降伏せずに切れるなら yield_force_n を書かない
wrong-break-displacement = break_displacement_m は延性の側の値。F_y も与える
wrong-minus-gap = d の逆向きは止めない。外すか、sides = "both" とする
wrong-no-area = 断面積を m² で与えるか、density_kg_m3 を与える
found-two-masses = ρ A a₀ = { $mass } kg と質量 { $given } kg
wrong-two-masses = area_m2 か density_kg_m3 の一方だけ、または 1 % 以内で一致する質量を与える
wrong-degree = 2 から 64 までの整数、または "auto" を与える
wrong-two-abutments = 橋台は動かず接触しない。桁を1つ以上指定する
wrong-touches-itself = 物体は自分とは接触しない。2つを指定する
wrong-not-facing = この2つは向かい合っていない。動かすか、`ends = ["+x", "-x"]` を加える
wrong-ends-away = この端は背を向け合っている。向かい合う端を指定する
wrong-nobody = "{ $name }" という名前の物体はない。{ $names }
wrong-names = 桁：{ $girders }、橋台：{ $abutments }
wrong-names-none = なし
wrong-assumed = --set と同じように、このファイルの値か表を指定する (girder.deck.mass_kg) か、外す
wrong-quake-length = 時間刻みの 2 ～ 1e6 倍の長さを与える
wrong-target = [周期 s, 擬似加速度 g] の組を2～1000個、周期の増加順に、2 dt_s から length_s まで与える
wrong-longest-of-target = target_psa_g があるときはその最長周期を使う。longest_period_s を外す
wrong-longest-period = 20 dt_s から length_s までの周期を与える
wrong-quake-coarse = 地盤の動きはそれより速い。もっと短い時間刻みを与える
wrong-sweep-length = 周期が多く 1e6 個を超えるデータが要る。継続時間を短くするか、振動数を下げる
wrong-cut = 切出しは { $whole } s の記録のデータを2個以上残すものとする
wrong-taper = 両方のテーパーが残りの { $length } s に収まるものとする
wrong-peak-of-nothing = 書かない：記録の値はすべて 0 で、倍率では最大値を作れない
wrong-padding = 小さくする。データは全部で 1e7 個まで
wrong-unwritable = このシーンは書き出せない
found-no-equals = `=` がない
wrong-setting = PATH=VALUE と書く。例：motion.angle_deg=45
found-steps = { $steps } 段のパス
found-empty-step = 空の段
wrong-not-there = その名前のものはここにない{ $meant }。あるもの：{ $there }
found-one-value = `{ $step }` は1つの値 ({ $found })
wrong-path-ends = パスはそこで終わる。キーをもたない
wrong-value = ファイルと同じ書き方で与える：45, true, paper, "two words", [0.07, 0.025]
wrong-key = ここにそのキーはない{ $meant }。ここで使えるキー：{ $known }
wrong-missing-key = 必須のキー：`{ $key } = …` を加える
wrong-missing-word = 必須のキー：`{ $key } = …` を加える。値は { $words } のどれか
wrong-type = ここには{ $expected }
wrong-word = { $words } のどれかを与える{ $meant }
type-number = 数
type-count = 0 以上の整数
type-list = 列：[…]、または二重の角かっこ [[…]] の下の表
type-table = キーの表：{"{"}…{"}"}、または角かっこ […] の下
type-word = ここで使える言葉
type-list-of = { $n } 個の値の列
wrong-did-you-mean = {" "}(`{ $known }` のことか)
wrong-format-write = このプログラムが読む形式は { $version }：`format = { $version }` と書く
found-line-column = { $line } 行目 { $column } 列目
wrong-toml = TOML ではない：{ $message }
wrong-preset = その名前の例題はない{ $meant }。例題：{ $names }
wrong-there = { $place }：{ $remedy }
found-pulled-slider = 静止時に { $load } N を受ける支承 { $number }
wrong-pulled-slider = すべり支承は引張を受けられない。支承を G のまわりに置くか、鉛直剛性を変える
found-face = 面
found-its-face = その面
found-no-face = 面がない
wrong-abutment-no-face = 実在する桁の前に gap_m か、4つの隅の polygon_m を与える
found-no-soil = 土がない
wrong-no-soil = unloading_stiffness_n_per_m は押込み 0 での勾配以上、stiffness_n_per_m × failing_push_m は ultimate_n より大きい値を与える

## ファイル
found-line = { $line } 行目
found-byte = { $byte } バイト目
found-file-itself = ファイル自体
found-not-text = UTF-8 の文字でない
wrong-not-text = シーンは UTF-8 で書いた TOML ファイルとする
wrong-no-record-file = シーンのファイルから見た記録のパスを与える
wrong-no-scene = シーンのファイルのパスか例題の名前を与える：{ $names }
found-unreadable = 読めない ({ $error })
found-kind = { $what }
found-size = { $size } MiB あり、読める上限 { $most } MiB を超える
wrong-unreadable = 実在して読めるファイルを与える
wrong-file-kind = 通常のファイルを与える
wrong-file-size = もっと小さいファイルを与える
file-folder = フォルダー
file-pipe = パイプ
file-socket = ソケット
file-device = デバイス
file-not-regular = 通常のファイルでない
unwritten = { $path }：書けない ({ $reason })：{ $remedy }
unwritten-no-folder = そのフォルダーはない
unwritten-denied = 許可がない
unwritten-not-folder = パスの途中がフォルダーでない
unwritten-folder = そこにフォルダーがある
unwritten-file-name = フォルダーを指定すべきところにファイルの名前がある
unwritten-read-only = ファイルシステムは読取り専用
unwritten-full = ディスクに空きがない
unwritten-quota = ディスクの割当てを使い切った
unwritten-large = ファイルの上限より大きい
unwritten-choose-folder = 書けるフォルダーを選ぶ
unwritten-make-room = 空きを作るか、書く量を減らすか、別のディスクに書く
unwritten-try-again = やり直すか、別のディスクに書く
gpu-none = 描画装置がない (ソフトウェアもない)：{ $set }{ $install }：{ $looked }
gpu-install-browser = WebGPU か WebGL2 のあるブラウザーで、ハードウェアの使用を入にする
gpu-no-device = 描画装置を使えない：{ $why }
gpu-no-surface = この画面には描けない：{ $why }
gpu-size = { $width } x { $height } ピクセルの画像：各辺 1 ～ { $most }、全部で 33,000,000 ピクセルまでとする
gpu-readback = 画像を読み戻せない：{ $why }
gpu-lost = 描画装置が失われた ({ $why })
gpu-no-memory = 描画装置のメモリーが足りない ({ $why })
gpu-refused = 描画装置で実行できない ({ $why })
gpu-unsaid = 理由は示されない
window-not-opened = ウィンドウを開けない：{ $why }
window-ended = ウィンドウを続けられない：{ $why }
window-ended-kept = ウィンドウを続けられない：{ $why }。保存していない内容は残してあり、次に開いたときに示す

## 検証範囲と設計基準の注記
condition-can-turn = 論文の条件 (6)、道示 (16.5.1)：a₀ sin 2β/(2 b₀) = { $number } ≥ 1：橋台の間で回転しうる
condition-cannot-turn = 論文の条件 (6)、道示 (16.5.1)：a₀ sin 2β/(2 b₀) = { $number } < 1：回転できない
code-note-caltrans = 支承線に直角。Δ_eq は計算した最大の開き。桁かかり側は動かない：ヒンジの Δ₂ = 0
code-note-caltrans-moves = 支承線に直角。Δ_eq は動く桁かかりに対する計算の最大の開き。caltrans_support が hinge でなければ最小値は橋台のもの
code-note-en-1998-2 = 縁に直角にとる。d_E は計算した最大の開き
code-note-aashto-lrfd = 支承の中心線に直角に測る
code-note-aashto-guide = Δ_eq は計算した最大の開き。基準自身の解析による要求値として
code-note-jra = 縁に直角にとる。u_R は桁かかりに対する計算上の最大変位
code-note-jra-rotation = 桁が G まわりに α_E 回転したときに桁端の中央が縁に直角に失う長さ。鋭角部はもっと失う
domain-unchecked = 検証したシーンにそのような桁はない
domain-tolerance = 許容誤差
domain-below-tolerance = 長い計算のステップが位置の丸めより小さい誤差を求められる
domain-above-tolerance = 1ステップが接触の半周期に及びうる。許容誤差を下げても誤差が減るとは限らない
domain-mend-tolerance = solver.tolerance を 1e-12 から 1e-4 の間とする。既定は 1e-10
domain-mass = 桁の質量
domain-mend-mass = 質量を kg で与える
domain-size = 桁の長さ、幅または厚さ
domain-above-size = 原点から遠い位置は 1e-13 m より粗く丸められ、浅い接触に影響する
domain-mend-size = 寸法を m で与える
domain-place = 桁の重心 G の座標
domain-above-place = 原点からこれほど遠い位置は 1e-10 m より粗く丸められ、遊間は位置の差である
domain-mend-place = 原点を橋の近くに置く
domain-skew = 桁の斜角
domain-mend-skew = 橋軸と支承線のなす角を度で与える。直橋は 90
domain-bearing-place = 最も遠い隅角部に対する支承の位置の比
domain-device-place = 最も遠い隅角部に対する装置の位置の比
domain-above-device-place = 桁はそこに達せず、それほど離れた力は追えないほど速い回転を生みうる
domain-above-bearing-place = 桁の下になく、追えないほど速い回転を生みうる
domain-pier-place = 桁の長さに対する支承と橋脚の距離の比
domain-above-pier-place = 橋脚がその下になく、桁端が離れた橋脚とともに動く
domain-mend-pier-place = 桁端を地盤か、その下の橋脚に載せる (on_minus_x、on_plus_x、支承ごとなら on)
domain-mend-bearing-place = 位置を桁の G から m で与える
domain-stiffness = 向かい合う組の K/M
domain-below-stiffness = 面が桁の大きさほど食い込む：もはや接触ではない
domain-above-stiffness = 静止した面の食い込みが位置の丸めと同程度になり、力が疑わしい
domain-mend-stiffness = K/M が範囲に入るように stiffness_n_per_m を定める。M = m₁m₂/(m₁+m₂)、橋台では桁の質量
domain-contact-phase = 計算全体の接触の位相 √(K/M) T
domain-above-contact-phase = 閉じたままの接触が許されるステップ数を超え、計算が早く終わりうる
domain-mend-contact-phase = duration_s を短くするか、stiffness_n_per_m を下げる
domain-motion-phase = 計算全体の支承、橋脚、ダンパー、地動または回転の位相 ω T
domain-above-motion-phase = 検証したどの計算より長く、ステップの誤差が積み重なる
domain-mend-motion-phase = duration_s を短くするか、振動数、減衰、回転速度を下げる
domain-acceleration = 外力、重力または地動による加速度
domain-above-acceleration = ステップの誤差が積み重なるほど桁が速く回転しうる
domain-mend-acceleration = 外力、重力または地動の振幅を下げる
domain-speed = 初期の、または初期条件が生む隅角部の速さ
domain-mend-speed = velocity_m_s、spin_deg_s、displacement_m または rotation_deg を下げる
domain-turn = 桁の初期回転角
domain-mend-turn = rotation_deg から整数回転分を引く
domain-friction = 静止摩擦係数
domain-unchecked-friction = 検証したシーンにそのような摩擦はない
domain-mend-friction = mu_static を下げる
domain-is-below = { $place }{ $of }：{ $quantity } = { $value } は検証範囲の下限 { $bound } より小さい：{ $consequence }。{ $remedy }
domain-is-above = { $place }{ $of }：{ $quantity } = { $value } は検証範囲の上限 { $bound } より大きい：{ $consequence }。{ $remedy }

## 計算が途中で終わる理由
stop-devices-in-impact = 衝撃モデルは装置、橋脚、降伏する支承、動く胸壁を扱わない
stop-space-in-impact = 衝撃モデルは平面内の剛な桁だけを扱う
stop-alternates = 1回の接触で状態が { $touch } 回変わり、うち { $same } 回はこの瞬間：固着と滑りが際限なく入れ替わる。別の摩擦則、低い剛性、または大きい許容誤差なら終わりうる
stop-device = 装置 { $name } の状態が1つの瞬間に際限なく変わる。許容誤差を小さくするか、遊びのある装置なら遊びを変える
stop-support-left = 鉛直支持を失う：{ $name } が ({ $x }, { $y }) m で桁かかりから外れた。これを除いて続けるには after_unseating = "continue" を与える
stop-support-dropped = 桁が支承から落下する：{ $name } が ({ $x }, { $y }, { $z }) m まで落ちた
stop-memory = ここまでのステップに { $bytes } MiB 要り、1回の計算の上限 { $most } MiB を超える
stop-pace = t = { $from } s からのステップと評価が { $done } 回：この調子では計算全体に { $expected } 回要り、上限を超える
stop-stands = t = { $at } s でのステップと評価が { $done } 回：時刻が進まない
stop-work = ステップと評価 { $work } 回が1回の計算の上限を超える
stop-too-fast = { $spent }：接触、支承、装置または地動が継続時間に対して速すぎる。その剛性、減衰または振動数を下げるか、ダンパーにブレースか大きい v_r を与えるか、計算時間を短くする
stop-hits-too-fast = { $spent }：衝突と接触状態の変化が継続時間に対して速すぎる。stop_speed_m_s を大きくするか restitution_normal を下げれば終わる。または接触モデルとする
stop-step = ステップが { $step } s まで縮んだ。剛性を下げるか許容誤差を大きくすれば追える
stop-starts-inside = { $depth } m 食い込んで始まる：剛な桁は重ならない。初期変位か位置で外に出すか、接触モデルとする
stop-nowhere = 衝突、探索、ステップが { $work } 回、うち { $same } 回はこの瞬間で、先に進まない。stop_speed_m_s を大きくするか restitution_normal を下げれば終わる。または接触モデルとする
stop-undefined = ここから先の運動は数にならない：プログラムの誤りであり、このシーンで再現できる
stop-no-motion = どれだけ短いステップでも接触を追えない：反力に対応する運動がここにはない
stop-no-contact = 衝撃モデルの接触がない所で出会う：扱うのは向かい合う端と宣言した組だけ。[model] で `kind = "contact"` とするか、組を宣言するか、[contact] の `between = "ends"` で通り抜けさせる

## 地震動の記録と計測値の表
record-error = { $line } 行目：{ $value }。{ $remedy }
record-format = 読める形式の記録を与える：{ $formats }
record-at2 = 単位、個数、時間刻みを含む見出し4行、続いて g の加速度
record-knet = 見出し17行、続いて記録器のカウント値。gal の倍率を乗じ、平均を引く
record-cosmos = 形式 v01.20 の volume 1 と 2、個数、書式、単位を見出しが示す加速度
record-csmip = 1つまたは複数の成分の補正済み加速度、個数、時間刻み、単位、書式を各々が示す
record-csv = 2列、時刻 s と加速度、見出しか `unit` が g か gal でなければ m/s²、1行に1データ
record-one-column = 1行に加速度1つ。時間刻みと単位は `# dt = 0.01 s, unit = g` のような見出しか、ファイルの外で与える
record-beside-value = ファイルの外で与えた { $key }
record-beside = { $states } { $key } を示す。ファイルの外の値を外す
record-states-at2 = AT2 のファイル自身が
record-states-knet = K-NET のファイル自身が
record-states-cosmos = COSMOS のファイル自身が
record-states-csmip = CSMIP のファイル自身が
record-states-csv = 時刻の表自身が
record-converted = { $unit } から係数 { $factor } m/s² で換算
record-counts = カウント値に { $scale } gal を乗じた
record-mean = 平均 { $mean } gal を除去
record-begins = 時刻は最初の値 (ファイルの { $begin } s) から数える
record-unit-assumed = 単位の記載がないため { $unit } と仮定
record-give-channel = channel を次から与える：{ $list }
record-end = ファイルの終わり
record-cut-off = ファイルが途切れている：{ $what }がない
record-not-finite = データはすべて 1e15 以下の数とする
record-interval-of = 時間刻み { $dt } s
record-interval = 時間刻みは 0 より大きくする
record-count = データの個数は2以上の整数とする
record-samples = データ { $count } 個
record-stated-samples = 見出しではデータ { $stated } 個：ファイル全体を取り直すか、欠けていなければ個数を直す
record-no-text = 文字でない
record-save-text = 記録を UTF-8 の文字で保存する
record-header = 見出し
record-station-line = 観測点と成分の行
record-unit-line = 単位の行
record-count-line = 個数と時間刻みの行
record-at2-unit = 3行目は ACCELERATION … IN UNITS OF G とする：速度と変位は読まない
record-at2-size = 4行目に両方の数を書く：NPTS=  4000, DT= .01000 SEC
record-knet-header = 見出し17行の一部
record-knet-frequency = サンプリング周波数は 100Hz のような数とする
record-knet-duration = 継続時間は s の数とする
record-knet-whole = 継続時間 × サンプリング周波数はデータの個数とする
record-knet-scale = 倍率は 3920(gal)/6182761 のように書く
record-series = 加速度の列
record-integers = 整数の見出し
record-reals = 実数の見出し
record-announcement = データを予告する行
record-end-line = `End-of-data` の行
record-end-after = 見出しではデータ { $count } 個：その後に `End-of-data` が続くものとする
record-no-interval = 時間刻みがない
record-cosmos-interval = 実数の見出しの62番目を ms の時間刻みとする
record-cosmos-first = 成分の最初の行は `(Format v01.20 with 13 text lines)` とする
record-text-header = 文字の見出しの一部
record-comments-line = 注釈を予告する行
record-comments-count = ここに注釈の行数を書く
record-comment = 注釈の行
record-comments = 注釈は { $count } 行、各々 | で始める
record-cosmos-unit = 単位は g、cm/sec2、m/sec2 のどれかとする：生のカウント値は読まない
record-lasts = 個数 × 時間刻みは { $seconds } s：個数、時間刻み、長さのどれかが誤り
record-sample-of = { $count } 個中 { $number } 個目のデータ
record-columns = { $found } 列
record-per-line = 見出しでは数 { $count } 個、1行に { $each } 個：ここには { $wanted } 個
record-column = 各列は 1e15 以下の数とする
record-columns-format = この行に数の書式を (8f10.6) のように書く
record-csmip-end = 成分を終える `/&` の行
record-csmip-unit = この行に加速度の単位を cm/sec2 のように書く
record-csmip-after = 見出しでは加速度 { $count } 個：その後に速度か `/&` が続くものとする
record-give-interval = 時間刻みを与える：`# dt = 0.01 s` の行か、ファイルの外の dt_s
record-give-unit = データの単位を与える：`# unit = g` の行か、ファイルの外の unit
record-two-lines = 記録には1行に1つ、2個以上のデータが要る
record-unit-of = 単位 { $unit }
record-cut-number = ファイルが最後の数の途中で終わっている：完全なファイルを使う
record-units = 加速度の単位は g、gal (cm/s2)、m/s2 のどれか
record-twice = ファイルの中と外の { $key }
record-once = 一方だけに書く
record-not-stated = それを示す行がない
record-units-differ = 見出しの { $stated } とファイルの外の { $beside }
record-unit-once = 単位は一方だけに書く
record-times-in = { $unit } の時刻
record-seconds = 時刻を s で与える
record-two-columns = 2列を与える：時刻 s、加速度 m/s²。小数点がコンマの数の列はセミコロンで区切る
record-time-finite = 時刻は s の 1e15 以下の数とする
record-acceleration-finite = 加速度は 1e15 以下の数とする
record-marks = 上の数と小数点が違う：1つに統一し、千の区切りは入れない
record-time = 時刻 { $t }
record-growing = 記録には2個以上のデータと増えていく時刻が要る
record-uneven = データは等間隔とする：間隔 { $dt } s ならこのデータは { $expected } s、{ $off } s 離れている{ $coarse }
record-coarse = 。時刻を { $unit } s より細かい桁まで書く
columns-time = 時刻 s
columns-frequency = 振動数 Hz
columns-both = { $first } と変位
columns-save-text = 表を UTF-8 の文字で保存する
columns-few-rows = 数の行が2行未満
columns-give-rows = { $words } の行を与える
columns-no-heading = 見出しのない { $count } 列
columns-write-heading = 数の上に名前の行を書く：t_s,x_mm
columns-no-unit = 単位のない変位
columns-state-unit = 単位を示す：見出しに x_mm のように書くか、--unit m、cm、mm、um を与える
columns-name-first = { $words } の列の名前を { $name } とする
columns-these = 列 { $names }
columns-this = 列 { $name }
columns-give = { $words } を与える
columns-none = 列 { $name } がない
columns-one-of = { $names } のどれかを与える
columns-one = 1列
columns-two = 2列を与える：{ $words }
columns-beside = { $name } のほかに { $count } 列
columns-choose = --column で1つ選ぶ：{ $names }
columns-units-differ = --unit が見出しの単位と違う：外すか、見出しを直す
columns-unitless = 単位のない列 { $name }
columns-finite = { $number } 列目は有限の数とする
columns-order = 行を増える順に、振動数は 0 より大きく与える
columns-many = { $most } 行を超える
columns-shorter = もっと短い表を与える
record-no-samples = データがない
processed-start = 始め
processed-end = 終わり
processed-cut = { $from } から { $to } までの値を切出し
processed-baseline = 基線：{ $kind } を除去
processed-taper = 両端に { $seconds } s のテーパー
processed-pad = 前後に { $seconds } s の零を付加 (データ間隔に丸め)
processed-time = 時間軸 × { $factor }
processed-peak = 最大加速度を { $peak } g に調整
processed-scale = × { $scale }
code-jra = 道示 V、S_E
code-jra-rotation = 道示 V、S_Eθ
code-aashto-lrfd = AASHTO LRFD 4.7.4.4、N
code-aashto-guide = AASHTO Guide Specifications、SDC D、N
code-caltrans = Caltrans SDC、N
code-en-1998-2 = EN 1998-2 6.6.4、l_ov
code-edition-jra = 2002 年 (英語版)。ε_G とそれ以降の版は未確認
code-edition-jra-rotation = 2002 年 (英語版)。それ以降の版は未確認
code-edition-aashto-lrfd = 第9版、2020 年
code-edition-aashto-guide = 第2版、2011 年
code-edition-caltrans = 2.0 版、2019 年
code-edition-en-1998-2 = 2005 + A2:2011。S、T_C、T_D は EN 1998-1:2004 の type 1
ledger-unsound = エネルギー収支の残差が最大エネルギーの { $residual } で、許容値 { $bound } を超える
neglected-centrifugal = 遠心力
neglected-coriolis = コリオリ力
neglected-inertia = 慣性モーメントの変化
neglected-thrust = 軸圧縮による軟化
neglected-side-load = 両端の間の側面への荷重
record-format-of = { $name } ({ $extensions })：{ $contents }
record-formats = { $one }; { $more }
