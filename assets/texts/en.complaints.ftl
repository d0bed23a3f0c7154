# What is wrong with a scene and what would be right, in English; every language has the same keys and values.

## a number out of its range
wrong-not-finite = it must be a finite number: { $remedy }
wrong-extreme = give a number from 1e-15 to 1e15
wrong-not-positive = give a number greater than 0
wrong-too-large = give a number no larger than 1e15
wrong-negative = give 0 or a number greater than 0
wrong-outside = give a number from { $low } to { $high }
wrong-not-between = give a number between { $low } and { $high }, the limits excluded
wrong-not-plain = give a plain number, no larger than 1e15
