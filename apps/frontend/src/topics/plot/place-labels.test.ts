import { describe, expect, it } from 'vitest';
import { placeLabels } from './place-labels.ts';

describe('placeLabels', () => {
  it('leaves labels with room where they are', () => {
    expect(placeLabels([10, 50, 90], 16, 100)).toEqual([10, 50, 90]);
  });

  it('moves labels apart in their order', () => {
    expect(placeLabels([52, 50, 51], 16, 200)).toEqual([82, 50, 66]);
  });

  it('stays within the plot', () => {
    expect(placeLabels([99, 98], 16, 100)).toEqual([100, 84]);
    expect(placeLabels([-5, -3], 16, 100)).toEqual([0, 16]);
  });
});
