# シーンの誤りと直し方（日本語）。見出し語と値の名前は en.complaints.ftl と同じ。

## 範囲外の数
wrong-not-finite = 有限の数とする：{ $remedy }
wrong-extreme = 1e-15 から 1e15 までの数を与える
wrong-not-positive = 0 より大きい数を与える
wrong-too-large = 1e15 以下の数を与える
wrong-negative = 0 以上の数を与える
wrong-outside = { $low } から { $high } までの数を与える
wrong-not-between = { $low } と { $high } の間の数を与える（両端を除く）
wrong-not-plain = 1e15 以下の普通の数を与える
