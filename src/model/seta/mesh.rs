//! How a seta is divided into elements.

use crate::beam::element::basis::MOST_ORDER;
use serde::{Deserialize, Serialize};

/// Elements of the branches of a seta, those of one branch of equal length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaMesh {
    /// Order p of the elements, 1 to 8
    pub order: usize,
    /// Of the shaft, then of each branch behind the first fork, the second one and so on
    pub elements: Vec<usize>,
}

/// Elements of the paper's seta, 1 700 in all on 256 tips.
const OF_THE_PAPER: [usize; 9] = [12, 8, 6, 6, 4, 4, 4, 3, 3];

impl SetaMesh {
    /// Of order 2: four elements along the shaft, two along a branch behind the first two forks, one along each other.
    pub fn usual(forks: usize) -> Self {
        let along = |generation| match generation {
            0 => 4,
            1 | 2 => 2,
            _ => 1,
        };
        Self { order: 2, elements: (0..=forks).map(along).collect() }
    }

    /// Of order 1, as many as the paper has for 8 forks; more forks as its last.
    pub fn of_the_paper(forks: usize) -> Self {
        Self { order: 1, elements: (0..=forks).map(|k| OF_THE_PAPER[k.min(OF_THE_PAPER.len() - 1)]).collect() }
    }

    /// The same with each element divided into so many.
    pub fn divided(&self, by: usize) -> Self {
        Self { order: self.order, elements: self.elements.iter().map(|n| n * by).collect() }
    }

    /// The same with elements one order higher; of the highest order each element divided in two.
    pub fn finer(&self) -> Self {
        if self.order < MOST_ORDER { Self { order: self.order + 1, ..self.clone() } } else { self.divided(2) }
    }

    /// Elements of all branches: 2ᵏ branches behind fork k.
    pub fn total(&self) -> usize {
        self.elements.iter().enumerate().map(|(k, n)| n << k).sum()
    }
}
