//! The tables of contact numbers, made from one list of them.

/// From one list: `[contact]`, `[[contact.pair]]` that lies over it, and the numbers in force for a pair.
macro_rules! contact_tables {
    (
        elasticity { $( $given:ident = $given_key:literal as $given_label:literal, $given_range:expr, $fallback:expr, $given_meaning:literal; )+ }
        given { $( $option:ident = $option_key:literal as $option_label:literal, $option_range:expr, $option_fallback:expr, $option_meaning:literal; )+ }
        numbers {
            $(
                $number:ident = $key:literal as $label:literal, $range:expr, $default:expr, $meaning:literal,
                slider $bounds:expr;
            )+
        }
        rules { $( $rule:ident: $Rule:ident = $rule_key:literal as $rule_label:literal, $rule_meaning:literal; )+ }
    ) => {
        $crate::scene::keys::table! {
            /// `[contact]`: numbers for every pair that `[[contact.pair]]` does not override.
            #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
            default struct ContactSettings, CONTACT {
                $( $given: Option<f64> = $given_key as $given_label, $given_range, $fallback, $given_meaning; )+
                $( $option: Option<f64> = $option_key as $option_label, $option_range, $option_fallback, $option_meaning; )+
                $( $number: f64 = $key as $label, $range, Fallback::Number($default), $meaning, slider $bounds; )+
                $( $rule: $Rule = $rule_key as $rule_label, Range::Words($Rule::WORDS), $Rule::FALLBACK, $rule_meaning; )+
                between: Between = "between" as "field-between", Range::Words(Between::WORDS), Between::FALLBACK,
                    "which faces can touch: any of any two bodies that come near, or facing ends and declared pairs alone";
                pairs: Vec<PairSettings> = "pair", Range::Free, Fallback::Words("none"), "[[contact.pair]], see below";
            }
        }

        $crate::scene::keys::table! {
            /// `[[contact.pair]]`: what differs between two named bodies; with `ends`, also declares the pair.
            #[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
            struct PairSettings, PAIR {
                between: [String; 2] = "between", Range::Like("two names"), Fallback::Needed("must be given"),
                    "the two bodies, in either order; at least one is a girder";
                ends: Option<[End; 2]> = "ends", Range::Like("two of \"+x\", \"-x\""),
                    Fallback::Words("every pair between the two"),
                    "only the pair of these ends, in the order of between; declares it if it is not found by itself. The \
                     end of an abutment is not looked at";
                $( $given: Option<f64> = $given_key as $given_label, $given_range, Fallback::Words("as in [contact]"), $given_meaning; )+
                $( $option: Option<f64> = $option_key as $option_label, $option_range, Fallback::Words("as in [contact]"), $option_meaning; )+
                $( $number: Option<f64> = $key as $label, $range, Fallback::Words("as in [contact]"), $meaning; )+
                $(
                    $rule: Option<$Rule> = $rule_key as $rule_label, Range::Words($Rule::WORDS), Fallback::Words("as in [contact]"),
                        $rule_meaning;
                )+
            }
        }

        /// The contact numbers in force for one pair, overrides and defaults filled in.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct PairContact {
            /// `K` of the pair (54), given or `E A / L` of (64), the smaller of the two girders' \[N/m\].
            pub stiffness: f64,
            $( #[doc = concat!("```text\n", $option_meaning, "\n```")] pub $option: Option<f64>, )+
            $( #[doc = concat!("```text\n", $meaning, "\n```")] pub $number: f64, )+
            $( #[doc = concat!("```text\n", $rule_meaning, "\n```")] pub $rule: $Rule, )+
        }

        /// A pure number of contact, in each of the places where it stands.
        #[derive(Clone, Copy, Debug)]
        pub struct ContactNumber {
            /// Its key.
            pub key: &'static str,
            /// Key of the text that names its field in the window.
            pub label: &'static str,
            /// For every pair.
            pub of_all: fn(&mut ContactSettings) -> &mut f64,
            /// For one pair, where that has one.
            pub of_pair: fn(&mut PairSettings) -> &mut Option<f64>,
            /// In force for one pair.
            pub in_force: fn(&PairContact) -> f64,
        }

        impl ContactNumber {
            /// Every one of them, in the order of the documentation.
            pub const ALL: &'static [Self] = &[$(
                Self {
                    key: $key,
                    label: $label,
                    of_all: |contact| &mut contact.$number,
                    of_pair: |pair| &mut pair.$number,
                    in_force: |contact| contact.$number,
                },
            )+];
        }

        impl ContactSettings {
            /// The settings without those of pairs, of which there may be as many as girders.
            pub(in crate::scene) fn alone(&self) -> Self {
                Self {
                    $( $given: self.$given, )+
                    $( $option: self.$option, )+
                    $( $number: self.$number, )+
                    $( $rule: self.$rule, )+
                    between: self.between,
                    pairs: Vec::new(),
                }
            }

            /// Puts what a pair gives in the place of what stands here.
            pub(in crate::scene) fn lay_over(&mut self, pair: &PairSettings) {
                $( self.$given = pair.$given.or(self.$given); )+
                $( self.$option = pair.$option.or(self.$option); )+
                $( self.$number = pair.$number.unwrap_or(self.$number); )+
                $( self.$rule = pair.$rule.unwrap_or(self.$rule); )+
            }

            /// The numbers in force, where K is this \[N/m\].
            pub(in crate::scene) fn in_force(&self, stiffness: f64) -> PairContact {
                PairContact {
                    stiffness,
                    $( $option: self.$option, )+
                    $( $number: self.$number, )+
                    $( $rule: self.$rule, )+
                }
            }
        }
    };
}

pub(super) use contact_tables;
