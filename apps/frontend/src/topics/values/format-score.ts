/** Formats the confidence of a detector: `.87`, and `1.00` for 1. */
export const formatScore = (score: number): string => score.toFixed(2).replace(/^0/, '');
