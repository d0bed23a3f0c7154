//! Groups of bodies that connections join: each is a run of its own.

use crate::dynamics::model::compiled_model::{Group, Model};

impl Model {
    /// Forms the groups of bodies by union over all connections that can act between two of them.
    pub(in crate::dynamics) fn regroup(&mut self) {
        let count = self.bodies.len();
        let [pairs, links] = [
            self.pairs.iter().map(|pair| pair.bodies).collect::<Vec<_>>(),
            self.links.iter().map(|link| link.bodies).collect(),
        ];
        self.groups = groups(count, &pairs, &links);
    }
}

/// Connected components of the numbers below `count` that `edges` join: each ascending, in the order of their least.
pub(in crate::dynamics) fn components(count: usize, edges: impl Iterator<Item = [usize; 2]>) -> Vec<Vec<usize>> {
    let mut root: Vec<usize> = (0..count).collect();
    for [a, b] in edges {
        let (a, b) = (root_of(&mut root, a), root_of(&mut root, b));
        root[a.max(b)] = a.min(b);
    }
    let mut groups: Vec<Vec<usize>> = vec![Vec::new(); count];
    for i in 0..count {
        groups[root_of(&mut root, i)].push(i);
    }
    groups.retain(|group| !group.is_empty());
    groups
}

/// Groups of the bodies below `count`, of pairs and links between bodies of these numbers; `None` is the ground or an abutment that stands.
fn groups(count: usize, pairs: &[[Option<usize>; 2]], links: &[[Option<usize>; 2]]) -> Vec<Group> {
    let between = |bodies: &[Option<usize>; 2]| Some([bodies[0]?, bodies[1]?]);
    let bodies = components(count, pairs.iter().chain(links).filter_map(between));
    let mut groups: Vec<Group> = bodies.into_iter().map(|bodies| Group { bodies, ..Group::default() }).collect();
    let mut group_of = vec![0; count];
    for (number, group) in groups.iter().enumerate() {
        group.bodies.iter().for_each(|&body| group_of[body] = number);
    }
    // Two bodies of one connection are in one group.
    let of = |bodies: &[Option<usize>; 2]| bodies.iter().flatten().next().map(|&body| group_of[body]);
    for (number, group) in pairs.iter().enumerate().filter_map(|(number, bodies)| Some((number, of(bodies)?))) {
        groups[group].pairs.push(number);
    }
    for (number, group) in links.iter().enumerate().filter_map(|(number, bodies)| Some((number, of(bodies)?))) {
        groups[group].links.push(number);
    }
    groups
}

/// The least number that `i` is joined to, in a forest of joined numbers.
fn root_of(root: &mut [usize], mut i: usize) -> usize {
    while root[i] != i {
        root[i] = root[root[i]];
        i = root[i];
    }
    i
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_are_those_of_the_graph_whatever_the_order_of_its_edges() {
        let edges = [[4, 1], [2, 3], [1, 4], [3, 0]];
        let expected = vec![vec![0, 2, 3], vec![1, 4], vec![5]];
        assert_eq!(components(6, edges.into_iter()), expected);
        assert_eq!(components(6, edges.into_iter().rev()), expected);
        assert_eq!(components(2, std::iter::empty()), [[0], [1]], "alone");
    }

    #[test]
    fn a_chain_of_connections_is_one_group_and_the_ground_joins_nothing() {
        let (pairs, links) = ([[Some(0), Some(2)], [None, Some(4)]], [[Some(2), Some(3)], [Some(1), None]]);
        let group = |bodies: &[usize], pairs: &[usize], links: &[usize]| Group {
            bodies: bodies.to_vec(),
            pairs: pairs.to_vec(),
            links: links.to_vec(),
        };
        let expected = [group(&[0, 2, 3], &[0], &[0]), group(&[1], &[], &[1]), group(&[4], &[1], &[])];
        assert_eq!(groups(5, &pairs, &links), expected);
    }
}
