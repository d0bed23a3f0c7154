//! Losses of a contact in its dashpots and in friction, and the work of the ground through it, step by step.

use crate::contact::{NormalLaw, locate};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::sim::History;
use crate::sim::energy::ledger_steps::{given_power, step_borders};
use crate::sim::energy::power_integrals::Account;
use crate::sim::energy::quadrature::integrate;

/// The account of one contact.
pub(in crate::sim) fn contact_account(history: &History, contact: usize) -> Account<4> {
    let mut account = Account::new();
    let site = &history.model().sites[contact];
    let states: Vec<(f64, Contact)> = history.trajectories.log(contact).states().collect();
    for (i, (from, state)) in states.iter().enumerate() {
        let until = states.get(i + 1).map_or(history.end(), |(t, _)| t.min(history.end()));
        let Contact::Closed(closed) = state else { continue };
        if until <= *from {
            continue;
        }
        let stored = |t: f64| {
            let [node, face] = history.trajectories.sides(contact, t);
            closed.law.normal.stored_energy(locate(&site.geometry_at(&closed.place), &node, &face).penetration())
        };
        let bodies = [site.node_body, site.face_body].into_iter().flatten();
        for w in step_borders(history, bodies, *from, until).windows(2).filter(|w| w[1] > w[0]) {
            let mut lost = integrate(w[0], w[1], |t| contact_powers(history, contact, t));
            if closed.held_at_zero && !closed.law.normal.is_along_stretch() {
                // Along the normal the dashpot takes what the spring gives, all of it: no quadrature, whose cells are long where no force acts
                // and whose error is that of the root at the opening. Of laws along the stretch the two springs exchange energy as bodies turn.
                lost[0] = stored(w[0]) - stored(w[1]);
            }
            account.add(w[0], w[1], lost);
        }
        // An idle cell after the last, so that what follows is not integrated again.
        account.add(until, until, [0.0; 4]);
    }
    account
}

/// Powers lost in the normal dashpot, the tangential dashpot and friction, and that of the ground where one side moves as given
/// \[W\].
pub(in crate::sim) fn contact_powers(history: &History, contact: usize, t: f64) -> [f64; 4] {
    let Some((closed, action)) = history.contacts().acting(contact, t) else { return [0.0; 4] };
    let [normal, tangential, friction] = closed.law.dissipated_powers(&action.forces);
    let site = &history.model().sites[contact];
    let given = given_power(history, [(site.node_body, action.force), (site.face_body, -action.force)], t);
    [normal, tangential, friction, given]
}
