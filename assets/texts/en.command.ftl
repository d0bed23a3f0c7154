# What the command line prints, in English; every language has the same keys and values.

## what run and check print
run-head = { $name }: { $end } of { $duration } s
run-model = model
run-impact = impact (rigid bodies, impulses)
run-outside = outside the domain
run-support-lost = support lost
run-too-deep = too deep
run-limit = limit passed
run-left-face = left a face
run-displacement = largest displacement
run-rotation = largest rotation
run-force = largest contact force
run-impulse = largest impulse
run-hits = hits
run-stick-slip = time in stick, slip
run-error = estimated error
run-ledger = ledger residual
run-time-taken = run time
run-digest = digest
run-overlap = overlap
run-uplift = uplift
run-tilt = largest tilt
run-total = force of two bodies
run-gave-up-at = at { $t } s, { $place }: { $reason }
run-lifts-at = { $bearing } carries nothing at { $t } s: it lifts
run-damped-at = { $bearing } carries nothing at { $t } s and lifts; its vertical dashpot pulls by up to { $pull } at { $tp } s while its spring is still pressed
run-pulls-at = { $bearing } carries nothing at { $t } s and then pulls, by up to { $pull } at { $tp } s: no uplift is in its law
run-total-at = { $force } at { $t } s, all contacts between two bodies together
run-pair-returns = ; returns e = { $returned }, { $asked } asked for
run-pair-total = , { $total } of all contacts together
run-lost-at = { $bearing } at { $t } s, at ({ $x }, { $y }) m: later samples are without it
run-pier-yields = ; it yields from { $t } s on, ductility { $ductility }; unloaded at the end { $along }, { $across } mm stay along, across
run-pier-numbers = alone T { $along } s along, { $across } s across; drift { $drift } mm at { $td } s, base shear { $shear } at { $ts } s{ $yielded }
run-pier = pier { $name }
run-bearings = bearings of { $girder }
run-bearings-of = move up to { $moved } mm in plan (bearing { $bearing }, { $t } s), force of one in plan up to { $force } (bearing { $which }, { $tf } s)
run-overlap-of = { $one } and { $other }, without contact: from { $t } s, { $depth } mm deep at { $td } s
run-overlap-more = { $more } more
run-too-deep-of = { $node } in { $face }: { $depth } mm at { $t } s, more than a tenth of the shortest side ({ $allowed } mm)
run-left-face-of = { $count ->
        [one] once
       *[other] { $count } times
    } with { $energy } J in the springs, { $share } of the largest energy; { $node } from { $face } at { $t } s the most
run-outside-more = and { $more } more
run-none-lasting = none that lasts
run-force-lasting = { $force } of a single corner, lasting
run-force-at = { $force } of a single corner at { $t } s
run-no-contact = no contact
run-impulse-at = { $impulse } N·s at { $t } s
run-hits-of = { $hits } ({ $touches } touches of single contacts)
run-stick-slip-of = { $stick } s, { $slip } s, summed over contacts
run-pair-of = law { $law }, { $touches } touches, peak { $peak } of a corner{ $total }
run-pair = pair { $name }
run-soil-of = pushed { $push } mm at { $t } s with { $force }, { $share } % of its ultimate force; a gap of { $gap } mm stays
run-soil = soil { $name }
run-unbalanced = : beyond its bound
run-error-of = { $error } (against a hundredth of the tolerance { $tolerance })
run-error-not = not asked for
run-ledger-of = { $residual } J, { $share } of the largest energy{ $unbalanced }
run-time-of = { $time } s, { $times } × real time
run-seat = seat { $girder }{ $end }
run-seat-lost = the whole end is off from { $t } s
run-seat-along = {" "}({ $length } along the axis)
run-seat-at = {" "}at { $which }
run-seat-of = placed { $placed } mm{ $along }, least { $least }{ $corner }, used { $used }, at { $t } s
run-corner = corner { $corner } ({ $angle })
run-corner-off = { $which } comes off at { $t } s, { $at } m along the edge; at worst { $share } % of the end's width is over its seat
run-corner-side = { $which } leaves the seat over its side at { $t } s
run-needed = needed
run-there = there
run-used = used
run-seats-head = seats, square to the edge [mm]
run-seats-legend = * quoted from memory, not confirmed in that edition; ° with assumed inputs, see `codes` of summary.json
run-seats-turned = turned about G nothing remains at the { $one } corner from { $first }°, at the { $other } from { $second }°, in the middle from { $middle }°
run-polynomials = polynomials
run-flexible = flexible { $girder }
run-flexible-rigid = elastic part below { $tol } (κ_e = { $kappa }): rigid
run-flexible-of = κ = { $kappa }, κ_e = { $kappae }, degree { $degree }, { $count } modes from { $frequencies } Hz, a₀/c = { $transit } ms
run-strength-of = passes { $strength } MPa: the girder is no longer elastic there
run-strength = strength
run-left-out = left out
run-warning = warning
run-hardest = hardest hit
run-not-negligible = not negligible: { $names }
run-returned = , the mass centres returned e = { $e }
run-hit-of = at { $t } s for { $time } ms{ $restitution }; { $ringing } J in the modes after it
run-hit-goes-on = from { $t } s on, { $time } ms until the end of the run; it has not ended; { $ringing } J in the modes
run-section-forces = mid-span |N| to { $axial } MN at { $t } s (strain differs by { $difference }), |M| to { $moment } MN·m{ $in_space }; fibre to { $stress } MPa at s = { $s } m
run-section-forces-space = , |M_y| to { $moment } MN·m, |T| to { $torque } MN·m
run-degrees = degree { $one } against { $other }: force { $force }, impulse { $impulse }, ends { $ends }, N at mid-span { $section }, moments there { $moments }
warning = warning: { $what }
warning-more-outside = warning: { $more } more quantities outside the domain
note = note: { $words }
warning-untrusted = do not trust this answer: heed the other warnings, or lower solver.tolerance
warning-balance = warning: { $name }: { $balance }: { $remedy }
failed-gave-up = the run of { $scene } { $ended } at t = { $t } s, { $place }: { $reason }
failed-interrupted = interrupted: { $kept }
failed = error: { $failure }
failed-no-pictures = this build has no pictures: build it with `cargo build --release --features render`
failed-standard-output = standard output: the answer cannot be written ({ $error }): redirect it to where there is space
run-removed = removed, of an earlier answer: { $names }
run-written = written to { $folder }: { $names }
failed-cells = --sample: { $samplehz }: { $table } would have { $cells } cells, more than { $most }: give at most { $less } samples a second, or a shorter run
failed-trajectory = the trajectory
report-written-to = written to { $file }
open-headless = { $why }: writing pictures and tables to { $folder } instead
open-no-window = this build has no window (feature gui)
failed-threads = --threads { $count }: they cannot be started ({ $error }): give fewer
wrong-out-before = --out stands before a command: give it after, where the command has one
mistake-of = { $what }: { $subject }
wrong-one-of = give one of { $words }
wrong-no-number = give a number
wrong-no-count = give a whole number of at least 1
wrong-not-above = give a number above 0
wrong-below = give a number of 0 or above
warning-unjoined = warning: { $one } and { $other }: { $apart } mm apart as placed, and they move by up to { $reach } mm without contact: no contact is defined between the two, so that they can pass through each other; give `between = "all"` in [contact] (contact model), place them farther apart or hold them stiffer, or see `overlap` in the summary of `girderbench run`
warning-more-unjoined = warning: { $more } more such pairs
check-touch-anywhere = bodies touch where they meet
check-touch-nowhere = nothing can touch
check-impact = impact model: e_n = { $en }, e_t = { $et }, μ_s = { $mus }, μ_k = { $muk } of a face, μ̄_s = { $cmus }, μ̄_k = { $cmuk } of a corner
check-impact-differs = the two models are of two joints: e_n = { $impact } in [impact], { $contact } in [contact]
check-no-pairs = no facing ends: { $elsewhere }
check-assumed = assumed: { $path } = { $value }
check-planar = planar
check-spatial = spatial, gravity { $gravity } m/s²
check-head = { $name }: { $kind }, { $duration } s
check-head-b = ground: { $motion }
check-named-ground = ground "{ $name }": { $motion }
check-unused-ground = ground "{ $name }", which nothing stands on and which moves nothing: { $motion }
check-head-c = solver: { $method }, tolerance { $tolerance }
check-head-d = view: { $camera }
check-assumed-stiffness = K of pairs without a number of their own: E A / L of their girders with A = width_m × thickness_m and L = a₀, of one that bends with its own E and A and L = a₀/10 (assumed)
check-pair = pair { $pair }: gap { $gap } mm along the axis, law { $law }, sharing { $sharing }, tension { $tension }
check-pair-gap = pair { $pair }: gap { $gap } mm along the axis
check-nodes = nodes: { $nodes }
check-normal-law = normal law { $law }, calibration { $calibration }: a free head-on hit at { $speed } m/s returns e = { $e }
check-node = { $node } on { $face }
check-girder-place = at { $place } m, heading { $heading }°
check-girder = girder { $name }: { $length } × { $width } × { $thickness } m, { $mass } kg, β = { $skew }° (skew_US { $complement }°), i = { $gyration } m
check-tilted = , pitched by { $pitch }° at { $pitchrate }°/s, rolled by { $roll }° at { $rollrate }°/s
check-starts = starts displaced by { $place } m, turned by { $turn }°, at { $velocity } m/s, { $spin }°/s{ $tilted }
check-pushed = pushed by { $force } N and { $moments } N·m
check-held = held in { $ways }
check-seat = { $length } m under { $end }
check-seat-wider = , { $side } m wider than the deck at either side
check-seats = seats: { $given }{ $wider }
check-no-bearings = no bearings
check-bearings = { $count } bearings: ω_x, ω_y, ω_θ = { $omega } rad/s ({ $hertz } Hz); h_x, h_y, h_θ = { $damping }
check-bearings-b = eccentricities of stiffness ε_x, ε_y = { $stiffness }, of dashpots η_x, η_y = { $dashpots }
check-density = its mass is { $density } kg/m³ of its size, concrete has 2500, steel 7850: is mass_kg in kg?
check-in-dish = bearing { $number } starts with { $part } times its load at rest: displaced so far in plan its dish rises by { $rise } m, which displacement_m does not
check-tips = its bearings do not hold it upright, all on one side of G or too close to a line: it tips over as soon as it is free to
check-pulled = bearing { $number } is pulled by { $pull } kN at rest: it holds the girder down
check-vertical = vertical: ω_z = { $omega } rad/s ({ $hertz } Hz), h_z = { $ratio }
check-can-rotate = it can rotate
check-cannot-rotate = it cannot rotate by itself
check-condition = condition (6): a0 sin 2β / (2 b0) = { $number }: { $can }
check-yield = { $count } of them yield: Q = { $force } N, k_x, k_y before = { $x }, { $y } N/m; frequencies are those after yield
check-flat = flat
check-slide = { $count } of them slide: μ = { $friction }, { $radius } (of the first), friction there at { $displacement } m; N follows their vertical force, frequencies are without N/R
check-assumed-of = ; assumed: { $numbers }
check-then-drops = the run stops when a corner has dropped by { $drop } m
check-then-stops = the run then stops
check-then-goes-on = the run goes on without it, and says so
check-rooms = { $count } of them can lose their support, the first beyond { $least } m square to the ends: { $then }
moved-own-ground = { " " }as "{ $ground }",
moved-support = { $name }:{ $ground } { $delay } s later, × { $factor }; up to { $largest } m from the ground of reference, { $last } m at the end
check-moving = ground under { $moved }
run-ground-under = ground under
check-on-piers = { $count } of them on { $piers }; frequencies are those on piers that stand still
check-on-abutments = { $count } of them on { $abutments }
check-flexible-rigid = rigid: elastic part below { $tol }
check-flexible-degree = degree { $degree }, { $count } modes from { $frequencies } Hz
check-flexible-twice = K is about E A / a₀: where it stands for the girder's own flexibility (64), that counts twice
check-flexible = elastic { $name }: A = { $area } m², I_z = { $second } m⁴, E A = { $axial } N, E I_z = { $bending } N·m², k_s G A = { $shear } N
check-flexible-space = I_y = { $second } m⁴, J_t = { $constant } m⁴, E I_y = { $bending } N·m², G J_t = { $torsion } N·m²
check-flexible-b = c = { $speed } m/s, a₀/c = { $transit } ms, κ = { $kappa }, κ_e = { $kappae }: { $degree }{ $twice }
check-ground = the ground
check-device = { $kind } { $name }: { $girder } at { $first } m to { $to } at { $second } m, { $length } m apart
check-cable = taut at { $slack } mm, K = { $stiffness } N/m
check-cable-yields = , yields at { $force } N ({ $at } mm beyond), then K₂ = { $after } N/m
check-cable-breaks = , breaks at { $elongation } mm beyond ({ $force } N)
check-bumper-point = { $force } N at { $depth } mm
check-bumper = pushes towards { $normal }, from { $gap } mm on; { $lines }, c = { $damping } N·s/m
check-brace = brace K_b = { $brace } N/m in series
check-regularised = regularised at { $speed } m/s
check-linear = linear
check-damper = F = { $c } |v|^{ $alpha } N: { $slow } N at 0.1 m/s, { $fast } N at 1 m/s; { $form }
check-stop-breaks = , breaks at { $force } N ({ $at } mm)
check-stop-yields = , yields at { $force } N ({ $at } mm)
check-stop-yields-breaks = , yields at { $force } N ({ $at } mm), breaks { $after } mm on
check-stopper = stops at { $sides } mm along { $along }, K = { $stiffness } N/m{ $fails }
run-device = { $kind } { $name }
run-device-never = its force never sets in
run-device-part = , { $part } % of its strength
run-device-yields = ; it yields from { $t } s on
run-device-breaks = ; it breaks at { $t } s
run-device-of = { $force } at { $t } s{ $part }; moves { $least } to { $greatest } mm; acts { $times ->
        [one] once, at { $first } s
       *[other] { $times } times from { $first } s on
    }{ $yields }{ $breaks }
kind-restrainer = restrainer
kind-bumper = bumper
kind-damper = damper
kind-stopper = stopper

## what the other commands print and refuse
wrong-bent = a number from 0 to 1e6, or auto
wrong-size = give width x height, each from 16 to 16384, such as 1280x720
wrong-instant = give a time of 0 s or later, or `peak`
wrong-frame-rate = give frames a second from 0.1 to { $most }
wrong-film-backwards = --to { $to }: the film begins at { $from } s: give a later time
wrong-one-file = --out { $out }: one file for { $count } pictures: give a folder
wrong-marks-view = --view { $view }: marks are seen straight from above: leave it out, or give top
wrong-marks-file = --out { $out }: --marks writes numbered pictures and marks.toml: give a folder
wrong-report-format = --out { $out }: a report is one file of HTML: give a name that ends in .html
wrong-picture-format = --out { $out }: pictures in the format .{ $format } are not written: give a file ending in .png for a single picture, one ending in .gif for a film, or a folder
wrong-gif-frames = --out { $out }: a GIF is a film: say how many --frames
wrong-gif-background = --background transparent: a GIF film has none: choose another, or a folder of PNG pictures
wrong-after-end = { $flag } { $t }: the run ends at { $end } s: give a time from 0 to { $end }
wrong-until-varied = --until: --vary duration_s says how long each run is; leave one of the two out
wrong-mark-mm = --mark-mm { $mm }: smaller marks are not seen, and larger ones run into one another: give { $least } to { $most }
wrong-exposure = --exposure-ms { $ms }: pictures are { $most } ms apart: give no more
wrong-rate = --rate { $rate }: { $count } pictures: give fewer than { $most }
render-marks = { $file }: { $count } marks, { $scale } mm a pixel
note-no-peak = nothing touches in this run: `--at peak` shows its start
render-finished-pictures = { $finished } of { $count } pictures are finished, in { $place }
render-finished-frames = { $finished } of { $count } frames are finished, in { $place }
render-frames = { $place }: { $count } frames, { $drawn } different
wrong-no-quantity = { $name }: the run has no such quantity{ $meant }; `--list` prints all names
wrong-girder-flag = --girder { $name }: no girder has this name; there are { $names }
wrong-no-wave = no girder bends, so no wave runs in one: give it [girder.elastic], and contacts stiff enough that it softens them
wrong-force-in-space = { $force } is a section force of spatial scenes: set kind = "spatial", or ask for another
wrong-picture-backwards = --to { $to }: the picture begins at { $from } s: give a later time
wrong-no-from = --to without --from: say when the picture begins
waves-largest = { $what }: largest { $largest } of { $times } instants and { $stations } stations
wrong-journal-busy = another process is at work on it: wait for its end, or give another --out
wrong-journal-other = it is the journal of another sweep: give another --out, or remove it
wrong-journal-changed = the solver or the measure is another than the one that these rows are of: give another --out, or remove the journal to compute every run anew
warning-journal = warning: { $file }: { $damaged } damaged lines are left out, and their runs computed again
sweep-by-version = the version of the program
sweep-by-scene = the scene
sweep-by-records = the records of ground motion
sweep-changed = it was changed
sweep-another = another sweep by { $parts }
wrong-sweep-folder = { $file }: found { $found }; give another --out, or the scene, --vary and --measure that the folder was begun with
sweep-runs = { $runs } runs, { $missing } of them to be computed
sweep-part = this part is complete; when all are, the same command without --shard writes the dataset
sweep-ended = { $count } runs { $how }; run { $run }: { $reason }
sweep-digest = dataset { $digest }
wrong-record-twice = { $name }: two records of this name: give each its own --out
motion-file = { $file }: { $format }, { $count } { $count ->
    [one] channel
   *[other] channels
 }
motion-unstated = direction not stated
motion-azimuth = azimuth { $azimuth }°
motion-up = upwards
motion-spectrum-title = { $record }: response spectrum, 5 % damping
motion-no-name = no name
motion-nothing = nothing
motion-channel = channel { $number }: { $name }, { $direction }
motion-samples = read in { $unit }: { $count } samples, { $dt } s apart, { $length } s
motion-peak = peak { $g } g = { $gal } gal at { $t } s
motion-ground = PGV { $velocity } m/s at { $tv } s, PGD { $displacement } m at { $td } s: integrated from rest, straight lines between samples
motion-strong = strong motion { $duration } s, from { $from } to { $until } s: 5 to 95 % of the Arias intensity of { $arias } m/s (significant duration)
motion-done = done to it: { $done }
wrong-scaled = --scaled: give the ground motion, with --scene or --record
wrong-no-girder-flag = --girder: give one of { $names }
wrong-shard = give I/N, the I-th of N parts, as in 1/8 to 8/8
wrong-nothing-common = { $a } and { $b }: { $instants } instants and { $quantities } quantities in common: give both the same bodies and --sample
wrong-both-read = { $flags }: { $a } and { $b } are folders of results, which are read and not run: leave it out, or give a scene
note-no-pictures = no pictures: { $why }
sweep-measures = Measures, with units:
sweep-outside = in { $count } of { $runs } runs, e.g. { $first }
sweep-refused = refused

## what compare, identify, measure and study print
compare-instants = { $count } instants in both
compare-until = { $which } ends at { $t } s: what the other has later is not compared
compare-instants-only = { $count } instants in both, { $others } in one only
compare-quantity = quantity
compare-difference = difference
compare-at = at t [s]
compare-largest = largest
compare-parts = parts by more than { $within } of the largest at
compare-never = never
compare-only = only in { $which }: { $names }
compare-events = events: { $a } in A, { $b } in B
compare-same-events = same events in the same order at { $count } contacts, times within { $apart } s
compare-event = { $contact }: A { $a }, B { $b }
compare-no-more = has no more
compare-event-at = { $kind } at { $t } s
compare-part-motion = { $name }, by more than { $within } of its largest
compare-part-events = the events of { $contact }
compare-part = part at t = { $t } s: { $what }
compare-agree = agree to { $apart } of the largest of each quantity
identify-rows = { $file }: { $count } rows{ $name }, { $from } to { $to } { $unit }, displacements in { $in }
identify-of = {" "}of { $name }
identify-ground = ground
identify-resonance = resonance
identify-resonance-of = { $frequency } Hz, where the search began
identify-as-given = , as given
identify-residual = residual
identify-residual-of = { $rms } mm RMS, { $share } % of the motion
identify-interval = ± is half of the interval that holds the true value 95 times in 100, of an oscillator
identify-at-bound = h lies at the highest that is looked for: it hardly swings, and neither f nor h nor their intervals can be relied on
identify-poor = it moves otherwise than an oscillator: the intervals have no sense (hits, slip, other ground?)
identify-independent = independent from row to row
identify-correlated = correlated from row to row by { $next } (autoregression of order { $order }), which the intervals account for
identify-still = at rest: a free decay
identify-sines = sines of constant acceleration
identify-shaken = of { $scene }, { $peak } g along { $angle }°
identify-no-shaking = { $scene }: its ground does not move along { $angle }°
identify-touches = warning: { $scene }: in this scene's own run { $pair } touches from { $t } s on, and an oscillator does not: use the rows before (--to), or find the scene's values with --fit
identify-frequency = natural frequency f
identify-damping = damping ratio h
identify-displacement = initial displacement
identify-velocity = initial velocity
identify-zero = zero of the scale
identify-factor = factor of the ground motion
identify-amplitude = amplitude of the ground
identify-too-few = { $have } rows within the time asked for: give { $need } at least
identify-no-motion = every displacement is the same: give a history that moves
identify-undetermined = f and h do not show: give a longer history, one that begins while it moves and does not grow, or the ground motion that it answers to
fit-key = give KEY=START
fit-number = START must be a number
fit-not-zero = START must be a number other than 0
fit-rows = { $file }: { $rows } rows of { $axes } of { $girder }
fit-both = x and y
fit-runs = runs of
fit-model = { $scene }, model "{ $model }"
fit-residual = { $rms } mm RMS, { $share } % of the motion, { $noise }
fit-correlated = correlated from row to row (autoregression of order { $order })
fit-outside = { $file }: { $have } rows up to { $last } s: give { $least } rows or more within the { $end } s of the run
fit-start = the scene does not run with { $values }: { $why }
fit-undetermined = { $keys } do not show in what was measured, or not apart: leave one out, or measure more (y shows friction)
fit-ended = the run ends at { $t } s, { $reason }: start from other values
fit-too-short = the run ends at { $end } s, and what was measured at { $last } s: --set duration_s={ $last }, or --to { $end }
wrong-brightness = give a number from 0 to below 255
measure-no-text = no text: write it as UTF-8
measure-dark = nothing stands out from the background: give bright marks, or --threshold
measure-count = { $count } marks of { $least } pixels or more: give another --threshold or --least-pixels
measure-picture = picture { $number }
measure-film = { $folder }: { $count } pictures of { $width } × { $height }, { $fps } a second from { $from } s
measure-marks = { $marks } marks brighter than { $threshold }; { $scale } mm a pixel
measure-range = { $low } to { $high }
measure-one-mark = one mark: no θ
measure-extent = { $body }: x { $x } mm, y { $y } mm, { $rotation }, since the first picture
measure-against = { $name } against the run: RMS { $rmspx } pixel = { $rms } mm, largest { $largestpx } pixel = { $largest } mm at { $t } s
measure-against-turn = θ against the run: RMS { $rms }°, largest { $largest }° at { $t } s
measure-too-few = the layout states { $count } pictures, { $have } are there: draw them again, or put it right
measure-no-pictures = no PNG pictures: give a folder that has some
measure-hole = after { $before } comes { $after }, and every picture is taken for the next instant: put what is missing there, or list the pictures themselves
measure-pixels = { $width } × { $height } pixels: give pictures of at most { $most } pixels
measure-no-picture = no PNG picture that is read ({ $error }): save it anew, or leave it out
measure-depth = a depth of colour that is not read: give 8 bits a channel
measure-no-body = no body { $body }: mark one of { $names }
measure-short = the run ends at { $end } s, the film at { $last } s: let it run on, or put from_s or fps right
layout-line = line { $line }: { $what }
layout-fps = fps { $fps }: give pictures a second, above 0
layout-from = from_s { $from }: give a time in s
layout-scale = mm_per_pixel: give a length above 0
layout-many = { $count } marks: give at most { $most }
layout-body = body: give names of 1 to 60 characters on one line
layout-none = no marks: give [[mark]] with body and pixel
layout-finite = pixel and at_mm must be finite numbers
layout-table = every mark is on the { $table }: give those of a body
layout-no-scale = no scale: give mm_per_pixel (--mm-per-pixel), or at_mm of two marks on the table or on one body
mark-missing = mark { $mark } ({ $body }) is missing: nothing bright within { $within } pixels of ({ $x }, { $y })
mark-merged = marks { $one } and { $other } are merged into one at ({ $x }, { $y })
mark-grown = mark { $mark } ({ $body }) has run together with something bright at ({ $x }, { $y }): { $area } pixels, { $first } at first
mark-shrunk = mark { $mark } ({ $body }) is partly covered at ({ $x }, { $y }): { $area } pixels, { $first } at first
mark-at-edge = mark { $mark } ({ $body }) reaches the edge of the picture at ({ $x }, { $y })
mark-size = it has { $width } × { $height } pixels, the first picture { $firstwidth } × { $firstheight }: give pictures of one size
study-written = written to { $folder }: { $count } files
study-none-of = { $flag }: "{ $name }" is none of { $known }: give some of these
study-computed = { $run } computed, { $there } there before; { $page }
study-seed = seed { $seed } ({ $family }): { $check }: { $detail }
study-seeds = { $seeds } seeds: { $inside } inside the domain, { $failedinside } failed; { $outside } outside, { $failedoutside } failed; written to { $folder }
study-failed = { $failed } of { $seeds } seeds failed: { $page } lists them with the command that repeats each
wrong-measure = no measure has this name{ $meant }; measures: { $names }
progress-of = { $reached } of { $whole } { $unit }{ $words }
progress-left = { $left } to go
progress-seconds = s
progress-runs = runs
progress-pictures = pictures
progress-results = results
progress-seeds = seeds
progress-error = estimating the error: the run at a hundredth of the tolerance
warning-drift = warning: { $words }
warning-more-drift = warning: { $more } more such supports
interrupted-nothing = nothing was written
progress-again = , again with contact between bodies that met
headless-no-render = this build has none (feature render)

gpu-without = { $name }={ $value } is set: try without it;
gpu-install-mesa = install mesa-vulkan-drivers (or libegl1 and libgl1-mesa-dri)
gpu-install-driver = install the graphics card's driver
