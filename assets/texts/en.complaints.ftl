# What is wrong with a scene and what would be right, in English; every language has the same keys and values.

## a complaint as one line
complaint = { $file }: { $place }: found { $value }; { $remedy }

## a number out of its range
wrong-not-finite = it must be a finite number: { $remedy }
wrong-extreme = give a number from 1e-15 to 1e15
wrong-not-positive = give a number greater than 0
wrong-too-large = give a number no larger than 1e15
wrong-negative = give 0 or a number greater than 0
wrong-outside = give a number from { $low } to { $high }
wrong-not-between = give a number between { $low } and { $high }, the limits excluded
wrong-not-plain = give a plain number, no larger than 1e15

## scenes
found-both = { $one } and { $other }
found-nothing = nothing
wrong-both = give one of the two
wrong-foreign = bearings of kind { $kind } have none: leave it out
found-number = a number
wrong-ratio-below-one = give more than 1: the bearing is stiffer before it yields
wrong-radius-and-period = give one of the two: T = 2π √(R/g)
found-gravity = gravity { $gravity } m/s²
wrong-weightless = its force follows from the weight: give gravity_m_s2
wrong-no-vertical-frequency = a girder in a spatial scene stands on its bearings: give their vertical frequency in Hz
wrong-no-places = give the bearings' places: at_m = [[x, y], …], or at_skewed_m
wrong-empty-places = give at least one place [x, y], or leave out `bearings`
wrong-no-bearing = give at least one bearing, or leave out `bearings`
wrong-no-vertical-stiffness = a girder in a spatial scene stands on its bearings: give a third, vertical number
wrong-no-yield-displacement = give the displacement at which the bearing yields, in m
wrong-no-yield-force = give the force Q in N, or leave out both
found-switch = a switch
complaints-more = and { $more } more
wrong-per-axis-slider = leave it out: the friction of a slider is the same in every direction
wrong-per-axis-alone = give yield_force_n and yield_displacement_m, or leave it out
wrong-friction-missing = give `friction` as well, or leave it out
wrong-slider-in-space = a slider in space goes by its vertical force: give a third, vertical stiffness
found-loads = { $sum } N in all
wrong-loads = loads at rest add up to the girder's weight, { $weight } N
found-loads-at = loads that act at [{ $x }, { $y }] m from G
wrong-loads-turn = friction goes by loads that carry the girder without a moment about G: place the bearings about G, or give load_n of each
found-all-loads = loads
wrong-loads-in-space = in a spatial scene vertical stiffness says them: leave load_n out
found-some-loads = some loads
wrong-some-loads = give load_n of all bearings, sliders among them, or of none
found-bearing-off-seat = bearing { $number } beyond the front edge of its seat as placed
wrong-bearing-off-seat = place it over the seat, make the seat longer, or leave out after_unseating
wrong-vertical-in-plan = a planar scene knows no vertical: give two numbers, or set kind = "spatial"
found-ends = { $width } m × { $thickness } m ends at { $skew }°
wrong-ends = no face can be computed from these ends: choose sizes and skew less extreme
found-device-far = a point { $far } times as far from G as the farthest corner
found-bearing-far = a bearing { $far } times as far from G as the farthest corner
wrong-device-far = nothing of the girder is there: give the place in m, relative to G
wrong-bearing-far = no bearing carries a girder from there: give its place in m, relative to G
wrong-fuse-force-missing = give fuse_force_n as well, or neither
wrong-fuse-stiffness-missing = give fuse_stiffness_n_per_m as well, or neither
wrong-no-face = give gap_m, or the face's corners as polygon_m
found-corners = { $count } corners
wrong-corners = give four corners [x, y, z]
wrong-beside-polygon = polygon_m says it already: leave this out
wrong-in-plan = a planar scene knows no vertical, roll or pitch: leave it out, or set kind = "spatial"
wrong-order = it must not exceed { $name } = { $most }: lower it, or raise { $name }
wrong-format = this program reads format { $version }
wrong-no-name = give the scene a name
wrong-no-girder = a scene needs at least one girder: add a [[girder]]
wrong-bilinear = the bilinear spring has no stiffness after yield up to e_n = { $least }: give more, or another normal_law
wrong-law-parameter = a head-on hit would return less than e = { $least }, or never part: give less
wrong-impact-in-space = the impact model knows planar scenes only: make it "contact", or kind = "planar"
wrong-impact-elastic = the impact model knows rigid girders only: make it "contact", or leave out [girder.elastic]
found-model-elastic = "{ $model }" with an elastic girder, { $girder }
wrong-impact-wave = the impact model knows one ground only: make it "contact", or leave out [wave], ground, delay_s and motion_factor
found-model-links = "{ $model }" with { $name }
wrong-impact-links = the impact model knows no devices, no piers, no bearings that yield, slide or can be lost and no backwalls that move: make it "contact", or leave them out
found-model-wave = "{ $model }" on ground that does not move as one
found-foot-wave = a foot that moves otherwise, up and down as well
wrong-foot-wave = a pier moves in plan alone: leave out the vertical part of the motion, or what moves its ground otherwise
found-slider-wave = a slider on ground that moves otherwise
wrong-slider-wave = in space a slider goes by the force of its own spring on the ground of reference: use a planar scene, or other bearings
wrong-stiffness-twice = K = E A / L comes from young_modulus_pa, area_m2 and contact_length_m: give either those or stiffness_n_per_m
wrong-no-amplitude = give the amplitude: amplitude_g, or amplitude_m_s2
wrong-no-such-girder = no girder has this name; { $names }
wrong-one-girder = both points are on one girder: name another body, or leave it out for the ground
wrong-device-on-pier = a pier: devices join girders, abutments and the ground; leave it out for the ground; { $names }
wrong-no-such-body = nobody has this name: leave it out for the ground; { $names }
wrong-pier-bears-nothing = no bearing stands on it: name it in a girder's bearings (on_plus_x, on_minus_x, on), or give its place [x, y]
wrong-pier-no-stiffness = give it in N/m, or frequency_hz, or column_m with height_m
wrong-same-thing = give one of them: they say the same thing
wrong-no-column-height = k = 3EI/h³ needs it: give the height of the column in m
found-modulus = a modulus
wrong-column-missing = it belongs to column_m: give that, or leave it out
wrong-not-whole = give a whole number
wrong-yield-force-missing = it belongs to yield_force_n: give that, or leave it out
wrong-turn-stiffness-missing = it belongs to turn_stiffness_n_m_per_rad: give that, or leave it out
wrong-slider-on-pier = in space a slider goes by the force of its own spring on the ground: put it there, or use a planar scene
found-slider-on-pier = a slider on a pier
wrong-no-pier = the scene has none: add a [[pier]]
wrong-piers = there are { $names }
wrong-no-ground = the scene has none: add a [[ground]]
wrong-no-such-ground = no ground has this name; { $known }, or leave it out for [motion]
wrong-no-such-pier = no pier or abutment has this name; { $known }, or leave it out for the ground
wrong-nameless = give it a name
wrong-name = tables and --set could not tell it apart: use letters, digits, - and _, and single spaces inside
wrong-ground-twice = another ground has this name: grounds need a name each
wrong-name-taken = plots call the ground or the ledger so, or measurements the shaking table: give another name
wrong-name-twice = another body has this name, or a device: girders, abutments, piers and devices need a name each
wrong-pair-friction = for { $pair } it exceeds the mu_static in force, { $mus }: lower it, or raise mu_static
wrong-face = this is no contact face: { $error }
wrong-leaning-face = a planar girder cannot slide up a leaning face: make it vertical, or kind = "spatial"
wrong-face-away = it faces away from { $girder }: list the corners anticlockwise as seen from there
found-leaning-backwall = a leaning backwall
wrong-leaning-backwall = a backwall that moves is upright: make its face vertical, or leave out backfill
wrong-soil-never-fails = the ultimate force { $force } N is not reached at { $push } m: raise either
wrong-soil-unloads = soil does not unload softer than it loads: give { $stiffness } or more
wrong-plan-height = a planar scene is cut at one height, which every body has, the others from { $low } to { $high } m: give it a z there, or set kind = "spatial"
found-heights = from { $low } to { $high } m
wrong-overlap = { $one } reaches { $depth } m into { $other }: move them apart
found-girder = girder { $name }
found-abutment = abutment { $name }
wrong-azimuth-of-one = it belongs to [[motion.component]]: give angle_deg of the one component
wrong-no-record = give samples_m_s2 with dt_s, or file
wrong-no-interval = give the interval between samples in seconds
wrong-of-a-file = it belongs to a file: leave it out
wrong-not-loaded = this record has not been read: load it beside the scene's file
found-samples = { $count } samples
wrong-too-few-samples = a record needs at least 2 samples
found-component-beside = component beside it
wrong-of-one-component = it is of a record of one component: state it in [[motion.component]], or leave that out
wrong-too-many-components = ground motion has three components at the most
wrong-intervals-differ = components have one interval, and that of the first is { $first } s: bring them to the same
found-upward = an upward component
wrong-upward-in-plan = a planar scene has no vertical: leave it out, or set kind = "spatial"
found-no-azimuth = no azimuth of world x
wrong-no-x-azimuth = give x_azimuth_deg in [motion]: components turn against it
wrong-no-direction = the file states no direction: give azimuth_deg, or vertical = true
wrong-points-too-near = a cable or damper needs a length of 1e-6 m or more: give to_m so far from where at_m is as placed
found-points-too-near = { $length } m between its points
wrong-no-vector = give a vector with a length: [1, 0] along, [0, 1] across
wrong-bumper-no-stiffness = give it in N/m, or a table depth_force_m_n
wrong-points-coincide = its points coincide: give a normal, or to_m elsewhere
wrong-bumper-behind = at_m lies behind the plane through to_m as placed: turn the normal, move a point, or give gap_m
found-distance = a distance of { $gap } m along the normal
wrong-depths = depth and force must both rise from (0, 0) on, line by line
wrong-no-depths = give at least one [depth, force]
wrong-cable-no-stiffness = give K in N/m, or EA as axial_stiffness_n
wrong-axial-stiffness-missing = it belongs to axial_stiffness_n: give that, or leave it out
wrong-post-yield = it must be less than K = { $before } N/m: lower it, or leave out yield_force_n
wrong-brittle-and-ductile = a brittle side has break_force_n, a ductile one yield_force_n: give one of the two
wrong-breaks-before-yield = it yields at T_y/K = { $yields } m: more than that; a cable that breaks without yield has no yield_force_n
wrong-break-displacement = break_displacement_m is that of a ductile side: give its F_y too
wrong-minus-gap = nothing stops motion against d: leave it out, or set sides = "both"
wrong-no-area = give the section's area in m², or density_kg_m3
found-two-masses = ρ A a₀ = { $mass } kg beside a mass of { $given } kg
wrong-two-masses = give area_m2 or density_kg_m3 alone, or a mass that agrees within 1 %
wrong-degree = give a whole number from 2 to 64, or "auto"
wrong-two-abutments = abutments stand still and never touch: name at least one girder
wrong-touches-itself = a body does not touch itself: name two
wrong-not-facing = these two do not face each other: move them, or add `ends = ["+x", "-x"]`
wrong-ends-away = these ends look away from each other: name the facing ones
wrong-nobody = nobody is called "{ $name }"; { $names }
wrong-names = girders: { $girders }; abutments: { $abutments }
wrong-names-none = none
wrong-assumed = name a value or a table of this file as --set does (girder.deck.mass_kg), or leave it out
wrong-quake-length = give a length of 2 to 1e6 intervals
wrong-target = give two to a thousand pairs [period in s, pseudo-acceleration in g], periods growing, from 2 dt_s to length_s
wrong-longest-of-target = beside target_psa_g the longest period of the target counts: leave longest_period_s out
wrong-longest-period = give a period from 20 dt_s to length_s
wrong-quake-coarse = the ground is quicker than that: give a shorter interval
wrong-sweep-length = so many periods need more than 1e6 samples: give a shorter sweep or lower frequencies
wrong-cut = the cut must leave at least 2 samples of the record's { $whole } s
wrong-taper = both tapers must fit into the { $length } s that are left
wrong-peak-of-nothing = leave it out: nothing shakes in the record, and no factor brings 0 to a peak
wrong-padding = give less: at most 1e7 samples in all
wrong-unwritable = this scene cannot be written
found-no-equals = no `=`
wrong-setting = write PATH=VALUE, as in motion.angle_deg=45
found-steps = a path of { $steps } steps
found-empty-step = an empty step
wrong-not-there = nothing here has this name{ $meant }; there is: { $there }
found-one-value = `{ $step }`, which is one value ({ $found })
wrong-path-ends = the path ends there: it has no keys
wrong-value = give a value as in the file: 45, true, paper, "two words", [0.07, 0.025]
wrong-key = no such key here{ $meant }; keys known here: { $known }
wrong-missing-key = this key must be given: add `{ $key } = …`
wrong-missing-word = this key must be given: add `{ $key } = …`, one of { $words }
wrong-type = expected { $expected }
wrong-word = expected one of { $words }{ $meant }
type-number = a number
type-count = a whole number, not negative
type-list = a list: […], or tables under double brackets, [[…]]
type-table = a table of keys: {"{"}…{"}"}, or under single brackets, […]
type-word = one of the words known here
type-list-of = a list of { $n } values
wrong-did-you-mean = ; did you mean `{ $known }`?
wrong-format-write = this program reads format { $version }: write `format = { $version }`
found-line-column = line { $line }, column { $column }
wrong-toml = not TOML: { $message }
wrong-preset = no preset has this name{ $meant }; presets: { $names }
wrong-there = { $place }: { $remedy }
found-pulled-slider = bearing { $number } under { $load } N at rest
wrong-pulled-slider = a slider cannot pull: place the bearings about G, or give them other vertical stiffness
found-face = a face
found-its-face = its face
found-no-face = no face
wrong-abutment-no-face = give gap_m, or polygon_m with four corners, before a girder that is there
found-no-soil = no soil
wrong-no-soil = give unloading_stiffness_n_per_m not below the slope at no push, and stiffness_n_per_m times failing_push_m above ultimate_n

## files
found-line = line { $line }
found-byte = byte { $byte }
found-file-itself = the file itself
found-not-text = not UTF-8 text
wrong-not-text = a scene is a TOML file, written as UTF-8 text
wrong-no-record-file = give the record's path relative to the scene's file
wrong-no-scene = give the path of a scene file or the name of a preset: { $names }
found-unreadable = it cannot be read ({ $error })
found-kind = it is { $what }
found-size = it has { $size } MiB, more than the { $most } MiB that are read
wrong-unreadable = give a file that is there and may be read
wrong-file-kind = give a regular file
wrong-file-size = give a smaller file
file-folder = a directory
file-pipe = a pipe
file-socket = a socket
file-device = a device
file-not-regular = no regular file
unwritten = { $path }: cannot be written ({ $reason }): { $remedy }
unwritten-no-folder = there is no such folder
unwritten-denied = permission denied
unwritten-not-folder = a part of the path is no folder
unwritten-folder = a folder stands there
unwritten-file-name = a folder is wanted, and that is the name of a file
unwritten-read-only = the file system is read-only
unwritten-full = the disk is full
unwritten-quota = the quota of the disk is used up
unwritten-large = it is larger than a file may be
unwritten-choose-folder = choose a folder that may be written to
unwritten-make-room = make room, write less, or write to another disk
unwritten-try-again = try again, or write to another disk
gpu-none = no graphics adapter, not even in software: { $set }{ $install }; { $looked }
gpu-install-browser = use a browser with WebGPU or WebGL2, and hardware acceleration switched on
gpu-no-device = the graphics adapter gives no device: { $why }
gpu-no-surface = nothing can be drawn on this display: { $why }
gpu-size = a picture of { $width } x { $height } pixels: choose 1 to { $most } each way, and no more than 33 million in all
gpu-readback = the picture could not be read back: { $why }
gpu-lost = the graphics device was lost ({ $why })
gpu-no-memory = the graphics device has no memory left ({ $why })
gpu-refused = the graphics device reports an error ({ $why })
gpu-unsaid = it does not say why
window-not-opened = no window could be opened: { $why }
window-ended = the window had to end: { $why }
window-ended-kept = the window had to end: { $why }; unsaved work is kept: it is offered when the program is opened again

## limits of the domain and notes of design codes
condition-can-turn = (6) of the paper, JRA (16.5.1): a₀ sin 2β/(2 b₀) = { $number } ≥ 1: can turn out between its abutments
condition-cannot-turn = (6) of the paper, JRA (16.5.1): a₀ sin 2β/(2 b₀) = { $number } < 1: cannot
code-note-caltrans = normal to the bearing line; Δ_eq is the greatest opening of the run; the seat does not move: Δ₂ = 0 at a hinge
code-note-caltrans-moves = normal to the bearing line; Δ_eq is the greatest opening of the run against the seat, which moves; the least is that at abutments unless caltrans_support says hinge
code-note-en-1998-2 = taken square to the edge; d_E is the greatest opening of the run
code-note-aashto-lrfd = measured normal to the centreline of bearing
code-note-aashto-guide = Δ_eq is the greatest opening of the run, for the demand of the code's own analysis
code-note-jra = taken square to the edge; u_R is the greatest displacement of the run relative to the seat
code-note-jra-rotation = what the middle of the end loses square to the edge when the deck turns by α_E about G; the acute corner loses more
domain-unchecked = no such girder is among the scenes that are checked
domain-tolerance = tolerance
domain-below-tolerance = steps of a long run are held to less than the rounding of a place
domain-above-tolerance = a step may span half a period of a contact, and a finer tolerance need not make the error smaller
domain-mend-tolerance = set solver.tolerance between 1e-12 and 1e-4; 1e-10 is the default
domain-mass = mass of a girder
domain-mend-mass = give the mass in kg
domain-size = length, width or thickness of a girder
domain-above-size = places so far from home round by more than 1e-13 m, and shallow contacts feel it
domain-mend-size = give the size in m
domain-place = coordinate of a girder's G
domain-above-place = places so far from the origin round by more than 1e-10 m, and gaps are differences of places
domain-mend-place = put the origin near the bridge
domain-skew = skew angle of a girder
domain-mend-skew = give the angle between axis and support line in degrees; 90 is straight
domain-bearing-place = place of a bearing over that of the farthest corner
domain-device-place = place of a device over that of the farthest corner
domain-above-device-place = the girder does not reach there, and a force so far from it may make it turn too fast to follow
domain-above-bearing-place = it does not stand under the girder, and may make it turn too fast to follow
domain-pier-place = distance of a bearing from its pier over the girder's length
domain-above-pier-place = the pier does not stand under it: an end moves with a pier that carries it in no bridge
domain-mend-pier-place = put the end on the ground or on the pier under it (on_minus_x, on_plus_x, or on of a bearing)
domain-mend-bearing-place = give the place in m, relative to the girder's G
domain-stiffness = K/M of a facing pair
domain-below-stiffness = faces go as deep into each other as a girder is large: that is no contact any more
domain-above-stiffness = faces at rest are pressed hardly deeper than a place rounds, and forces are in doubt
domain-mend-stiffness = set stiffness_n_per_m so that K/M, with M = m₁m₂/(m₁+m₂) or the girder's mass at an abutment, lies in the range
domain-contact-phase = phase of a contact over the run, √(K/M) T
domain-above-contact-phase = a contact that stays closed may take more steps than the run is allowed, and end it early
domain-mend-contact-phase = shorten duration_s or lower stiffness_n_per_m
domain-motion-phase = phase of bearings, piers, dampers, ground or spin over the run, ω T
domain-above-motion-phase = the run is longer than any that is checked, and the errors of its steps add up
domain-mend-motion-phase = shorten duration_s, or lower the frequency, the damping or the spin
domain-acceleration = acceleration by push, gravity or ground
domain-above-acceleration = girders may come to tumble so fast that the errors of their steps add up
domain-mend-acceleration = lower the push, gravity or the amplitude of the ground
domain-speed = speed of a corner at the start, or that its start leads to
domain-mend-speed = lower velocity_m_s, spin_deg_s, displacement_m or rotation_deg
domain-turn = turn of a girder at the start
domain-mend-turn = take whole turns away from rotation_deg
domain-friction = coefficient of static friction
domain-unchecked-friction = no such friction is among the scenes that are checked
domain-mend-friction = lower mu_static
domain-is-below = { $place }{ $of }: { $quantity } = { $value } is below { $bound }, outside the domain: { $consequence }; { $remedy }
domain-is-above = { $place }{ $of }: { $quantity } = { $value } is above { $bound }, outside the domain: { $consequence }; { $remedy }

## why a run ends early
stop-devices-in-impact = the impact model knows no devices, no piers, no bearings that yield and no backwalls that move
stop-space-in-impact = the impact model knows rigid girders in plan only
stop-alternates = { $touch } changes of state in one touch, { $same } of them at this instant: stick and slip alternate without end; another law, a lower stiffness or a larger tolerance may end it
stop-device = the device { $name } changes its phase without end at one instant; a smaller tolerance may get past it, or, of one with a gap, another slack
stop-support-left = vertical support is lost: { $name } left its support at ({ $x }, { $y }) m; give after_unseating = "continue" to go on without it
stop-support-dropped = the girder comes off its supports: { $name } has dropped to ({ $x }, { $y }, { $z }) m
stop-memory = the steps so far take { $bytes } MiB, more than the { $most } MiB that a run may take
stop-pace = { $done } steps and evaluations since t = { $from } s: at this pace the run would take { $expected } of them, beyond what a run may take
stop-stands = { $done } steps and evaluations at t = { $at } s, without getting on in time
stop-work = { $work } steps and evaluations exceed the bound on the work of a run
stop-too-fast = { $spent }: a contact, a bearing, a device or the ground is far too fast for the duration; lower its stiffness, damping or frequency, give a damper a brace or a larger v_r, or shorten the run
stop-hits-too-fast = { $spent }: hits and changes of lasting contact follow one another far too fast for the duration; a larger stop_speed_m_s or a lower restitution_normal would end them, or the contact model
stop-step = the step fell to { $step } s; a lower stiffness or a larger tolerance would be followed
stop-starts-inside = it starts { $depth } m inside: rigid girders cannot overlap; move it out by its initial displacement or its place, or take the contact model
stop-nowhere = { $work } hits, searches and steps, { $same } of them at this instant, make no progress; a larger stop_speed_m_s or a lower restitution_normal would end it, or the contact model
stop-undefined = its motion is no number from here on: a fault of the program, which the scene helps to find
stop-no-motion = no step is short enough to follow the contact: its reactions have no motion here
stop-no-contact = they meet where the impact model has no contact: it knows facing ends and declared pairs; choose `kind = "contact"` in [model], declare the pair, or let bodies pass with `between = "ends"` in [contact]

## records of ground motion and measured tables
record-error = line { $line }: found { $value }; { $remedy }
record-format = give a record in a format that is read: { $formats }
record-at2 = four header lines with unit, count and interval, then accelerations in g
record-knet = seventeen header lines, then counts of the digitiser; times the scale factor in gal, less their mean
record-cosmos = volumes 1 and 2 of format v01.20, accelerations with count, format and unit as the header states them
record-csmip = corrected accelerations of one channel or several, with count, interval, unit and format as each states them
record-csv = two columns, time in s and acceleration, in m/s² unless a heading or `unit` says g or gal, one line a sample
record-one-column = one acceleration a line; interval and unit in header lines, as in `# dt = 0.01 s, unit = g`, or beside the file
record-beside-value = { $key } stated beside the file
record-beside = { $states } { $key }: leave it out beside the file
record-states-at2 = an AT2 file states its own
record-states-knet = a K-NET file states its own
record-states-cosmos = a COSMOS file states its own
record-states-csmip = a CSMIP file states its own
record-states-csv = a table of times states its own
record-converted = converted from { $unit } by the factor { $factor } m/s²
record-counts = counts scaled by { $scale } gal
record-mean = mean of { $mean } gal removed
record-begins = times counted from the first sample, at { $begin } s in the file
record-unit-assumed = no unit is stated: { $unit } assumed
record-give-channel = give channel, one of: { $list }
record-end = the end of the file
record-cut-off = the file is cut off: { $what } is missing
record-not-finite = every sample must be a number no larger than 1e15
record-interval-of = an interval of { $dt } s
record-interval = the interval between samples must be greater than 0
record-count = the count of samples must be a whole number of at least 2
record-samples = { $count } samples
record-stated-samples = the header states { $stated } samples: get the whole file again, or put the count right if the file is whole
record-no-text = no text
record-save-text = save the record as UTF-8 text
record-header = the header
record-station-line = the line of station and component
record-unit-line = the line of the unit
record-count-line = the line of count and interval
record-at2-unit = the third line must read ACCELERATION … IN UNITS OF G: velocities and displacements are not read
record-at2-size = the fourth line must give both numbers: NPTS=  4000, DT= .01000 SEC
record-knet-header = a part of the seventeen header lines
record-knet-frequency = the sampling frequency must be a number, as in 100Hz
record-knet-duration = the duration must be a number, in s
record-knet-whole = duration times sampling frequency must be a number of samples
record-knet-scale = the scale factor must be written as 3920(gal)/6182761
record-series = a series of accelerations
record-integers = the integer header
record-reals = the real header
record-announcement = the line that announces the samples
record-end-line = the line `End-of-data`
record-end-after = the header states { $count } samples: `End-of-data` must follow them
record-no-interval = no interval
record-cosmos-interval = real-header value 62 must be the interval between samples, in ms
record-cosmos-first = the first line of a channel must read `(Format v01.20 with 13 text lines)`
record-text-header = a part of the text header
record-comments-line = the line that announces the comments
record-comments-count = the number of comment lines must be announced here
record-comment = a comment line
record-comments = { $count } comment lines are announced, each starting with |
record-cosmos-unit = the unit must be g, cm/sec2 or m/sec2: raw counts are not read
record-lasts = count times interval is { $seconds } s: count, interval or length is wrong
record-sample-of = sample { $number } of { $count }
record-columns = { $found } columns
record-per-line = the header states { $count } numbers, { $each } a line: { $wanted } here
record-column = every column must be a number no larger than 1e15
record-columns-format = the line must state the format of its numbers, such as (8f10.6)
record-csmip-end = the line `/&` that ends a channel
record-csmip-unit = the line must state the unit of the accelerations, such as cm/sec2
record-csmip-after = the header states { $count } accelerations: velocities or `/&` must follow them
record-give-interval = give the interval between samples: a line `# dt = 0.01 s`, or dt_s beside the file
record-give-unit = give the unit of the samples: a line `# unit = g`, or unit beside the file
record-two-lines = a record needs at least 2 samples, one a line
record-unit-of = unit { $unit }
record-cut-number = the file ends within its last number: copy it again as a whole
record-units = a unit of acceleration is g, gal (cm/s2) or m/s2
record-twice = { $key } in the file and beside it
record-once = state it once
record-not-stated = no line that states it
record-units-differ = { $stated } in the heading, { $beside } beside the file
record-unit-once = state the unit once
record-times-in = times in { $unit }
record-seconds = give times in s
record-two-columns = give two columns: time in s, acceleration in m/s²; columns of numbers with decimal commas are separated by semicolons
record-time-finite = the time must be a number no larger than 1e15, in s
record-acceleration-finite = the acceleration must be a number no larger than 1e15
record-marks = numbers above have another decimal mark: use one, and nothing between thousands
record-time = time { $t }
record-growing = a record needs at least 2 samples, and times that grow
record-uneven = samples must be evenly spaced: with { $dt } s between them this one belongs at { $expected } s, { $off } s away{ $coarse }
record-coarse = : print the times with more digits than to { $unit } s
columns-time = time in s
columns-frequency = frequency in Hz
columns-both = { $first } and displacement
columns-save-text = save the table as UTF-8 text
columns-few-rows = fewer than two rows of numbers
columns-give-rows = give rows of { $words }
columns-no-heading = { $count } columns without a heading
columns-write-heading = write a line of names above the numbers: t_s,x_mm
columns-no-unit = displacements without a unit
columns-state-unit = state the unit: in the heading, as x_mm, or with --unit m, cm, mm or um
columns-name-first = name the column of { $words } { $name }
columns-these = the columns { $names }
columns-this = the column { $name }
columns-give = give { $words }
columns-none = no column { $name }
columns-one-of = give one of { $names }
columns-one = one column
columns-two = give two: { $words }
columns-beside = { $count } columns beside { $name }
columns-choose = choose one with --column: { $names }
columns-units-differ = --unit differs from the unit in the heading: leave it out, or change the heading
columns-unitless = the column { $name } without a unit
columns-finite = column { $number } must hold finite numbers
columns-order = give rows in growing order, frequencies above 0
columns-many = more than { $most } rows
columns-shorter = give a shorter table
record-no-samples = no samples
processed-start = its start
processed-end = its end
processed-cut = cut to the samples from { $from } to { $to }
processed-baseline = baseline: { $kind } removed
processed-taper = tapered over { $seconds } s at both ends
processed-pad = { $seconds } s of rest before and after, to the nearest sample
processed-time = time scaled by { $factor }
processed-peak = scaled to a peak of { $peak } g
processed-scale = multiplied by { $scale }
code-jra = JRA part V, S_E
code-jra-rotation = JRA part V, S_Eθ
code-aashto-lrfd = AASHTO LRFD 4.7.4.4, N
code-aashto-guide = AASHTO Guide Specifications, SDC D, N
code-caltrans = Caltrans SDC, N
code-en-1998-2 = EN 1998-2 6.6.4, l_ov
code-edition-jra = 2002 (English); ε_G and later editions not read
code-edition-jra-rotation = 2002 (English); later editions not read
code-edition-aashto-lrfd = 9th edition, 2020
code-edition-aashto-guide = 2nd edition, 2011
code-edition-caltrans = version 2.0, 2019
code-edition-en-1998-2 = 2005 + A2:2011; S, T_C, T_D of EN 1998-1:2004, type 1
ledger-unsound = the ledger's residual is { $residual } of the largest energy, more than the { $bound } of a sound answer
neglected-centrifugal = centrifugal force
neglected-coriolis = Coriolis force
neglected-inertia = change of inertia
neglected-thrust = softening by thrust
neglected-side-load = load on a side between the ends
record-format-of = { $name } ({ $extensions }): { $contents }
record-formats = { $one }; { $more }
