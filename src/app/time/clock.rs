//! The playing clock: what time of the answer is shown.
//!
//! Slow motion is here alone: the physics has no clock, playing is a look-up in a finished answer. The clock is advanced by the time that a
//! frame says has passed, so a test can play without waiting.

/// Playing speeds, in seconds of the answer per second on the wall.
pub const SPEEDS: [f64; 13] = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// Speed while a contact is closed and [`Clock::slow_at_hits`] is on.
pub const HIT_SPEED: f64 = 0.01;

/// How far before a touch the clock already slows down \[s of the answer\].
const HIT_LEAD: f64 = 0.004;

/// Longest step that one frame may play, so that a stall of the window is no jump \[s on the wall\].
const LONGEST_FRAME: f64 = 0.25;

/// Time shown, and its rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Clock {
    /// Time shown \[s\].
    pub t: f64,
    /// Whether it runs.
    pub playing: bool,
    /// Seconds of the answer per second on the wall.
    pub speed: f64,
    /// Begin again at the end.
    pub looping: bool,
    /// Slow down by itself around hits.
    pub slow_at_hits: bool,
    /// The stretch that is played, instead of everything \[s\].
    pub span: Option<[f64; 2]>,
}

impl Default for Clock {
    fn default() -> Self {
        Self { t: 0.0, playing: false, speed: 0.1, looping: true, slow_at_hits: false, span: None }
    }
}

impl Clock {
    /// Advances by `dt` seconds on the wall; `end` is the end of the answer, `touches` the closed intervals, ordered.
    pub fn advance(&mut self, dt: f64, end: f64, touches: &[(f64, f64)]) {
        if !self.playing {
            return;
        }
        let before = self.t;
        let mut left = dt.clamp(0.0, LONGEST_FRAME);
        // A frame may enter and leave a touch: each stretch at its own speed.
        for _ in 0..8 {
            let (speed, until) = self.stretch(touches);
            let wanted = self.t + left * speed;
            if wanted <= until {
                self.t = wanted;
                break;
            }
            left -= (until - self.t) / speed;
            self.t = until;
        }
        // A playhead put behind the stretch plays on to the end of everything.
        let span = self.span.filter(|s| before < s[1]);
        let [start, end] = span.map_or([0.0, end], |s| [s[0].min(end), s[1].min(end)]);
        if self.t >= end {
            self.wrap(start, end);
        }
    }

    fn wrap(&mut self, start: f64, end: f64) {
        if self.looping && end > start {
            self.t = start + (self.t - start) % (end - start);
        } else {
            self.t = end;
            self.playing = false;
        }
    }

    /// Speed from here on, and how far it holds.
    fn stretch(&self, touches: &[(f64, f64)]) -> (f64, f64) {
        if !self.slow_at_hits || self.speed <= HIT_SPEED {
            return (self.speed, f64::INFINITY);
        }
        let next = touches.partition_point(|&(_, end)| end <= self.t);
        match touches.get(next) {
            Some(&(start, end)) if start - HIT_LEAD <= self.t => (HIT_SPEED, end),
            Some(&(start, _)) => (self.speed, start - HIT_LEAD),
            None => (self.speed, f64::INFINITY),
        }
    }

    /// The next faster (`+1`) or slower (`-1`) of [`SPEEDS`].
    pub fn step_speed(&mut self, by: i32) {
        let next = if by > 0 {
            SPEEDS.iter().find(|&&s| s > self.speed * (1.0 + 1e-9))
        } else {
            SPEEDS.iter().rev().find(|&&s| s < self.speed * (1.0 - 1e-9))
        };
        if let Some(&speed) = next {
            self.speed = speed;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn playing(speed: f64) -> Clock {
        Clock { playing: true, speed, ..Clock::default() }
    }

    #[test]
    fn a_frame_plays_its_length_times_the_speed() {
        let mut clock = playing(0.1);
        clock.advance(0.02, 10.0, &[]);
        assert!((clock.t - 0.002).abs() < 1e-15, "0.02 s at a tenth, got {}", clock.t);
    }

    #[test]
    fn the_end_loops_or_stops() {
        let mut looped = Clock { t: 9.99, ..playing(1.0) };
        looped.advance(0.02, 10.0, &[]);
        assert!((looped.t - 0.01).abs() < 1e-9 && looped.playing, "begins again, got {}", looped.t);
        let mut once = Clock { t: 9.99, looping: false, ..playing(1.0) };
        once.advance(0.02, 10.0, &[]);
        assert!(once.t == 10.0 && !once.playing, "stops at the end, got {}", once.t);
    }

    #[test]
    fn a_stretch_is_played_again_and_again() {
        let mut clock = Clock { t: 2.9, span: Some([2.0, 3.0]), ..playing(1.0) };
        clock.advance(0.2, 10.0, &[]);
        assert!((clock.t - 2.1).abs() < 1e-9, "back to its start, got {}", clock.t);
        let mut beyond = Clock { t: 5.0, ..clock };
        beyond.advance(0.2, 10.0, &[]);
        assert!((beyond.t - 5.2).abs() < 1e-9, "who stands behind it is left alone, got {}", beyond.t);
    }

    #[test]
    fn a_hit_shorter_than_a_frame_is_still_slowed() {
        let mut clock = Clock { slow_at_hits: true, t: 0.99, ..playing(1.0) };
        clock.advance(0.1, 10.0, &[(1.0, 1.01)]);
        assert!(clock.t > 0.996 && clock.t < 1.0, "arrived at the lead and slowed there, got {}", clock.t);
        for _ in 0..40 {
            clock.advance(0.1, 10.0, &[(1.0, 1.01)]);
        }
        assert!(clock.t > 1.01, "and leaves it again, got {}", clock.t);
    }

    #[test]
    fn speeds_step_through_the_list_and_stay_in_it() {
        let mut clock = playing(1.0);
        for _ in 0..40 {
            clock.step_speed(-1);
        }
        assert_eq!(clock.speed, 0.001, "slowest");
        clock.step_speed(1);
        assert_eq!(clock.speed, 0.002, "one up");
    }
}
