//! Energy: what is stored, where it went, and whether it balances (`docs/physics.md#energy-ledger`).
//!
//! The `ledger` is read from integrals of powers over the run (`power_integrals`, of contacts `contact_account`), by the
//! `quadrature` that is exact on steps.

pub mod balance;
mod contact_account;
pub mod entries;
mod ledger;
mod ledger_steps;
pub(super) mod power_integrals;
pub(super) mod quadrature;
pub(super) mod quantity;
pub mod view;
