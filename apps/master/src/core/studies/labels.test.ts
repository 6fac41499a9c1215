import { describe, expect, it } from 'vitest';
import { requireLabel } from './labels.ts';

describe('a code of a participant, and a visit', () => {
  it.each(['', 'P 01', 'P-01', '../P01', 'P01\n', 'é', 'P'.repeat(33)])(
    'is not "%s" [ST-11]',
    (text) => {
      expect(() => requireLabel('visit', text)).toThrow(/member visit .* letters/);
    },
  );
});
