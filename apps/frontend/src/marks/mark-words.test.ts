import { describe, expect, it } from 'vitest';
import { takenSentence } from './mark-words.ts';

const THEO = { name: 'Theo', mark: { shape: 2, colour: 2 } };
const IDA = { name: 'Ida', mark: { shape: 3, colour: 3 } };
const LEO = { name: '', mark: { shape: 4, colour: 4 } };

describe('the sentence on marks [EX-100]', () => {
  it.each([
    [[], 'All are free.'],
    [[THEO], 'Theo is the blue triangle. All others are free.'],
    [[THEO, IDA], 'Theo is the blue triangle, Ida is the yellow square. All others are free.'],
    [[THEO, IDA, LEO], '3 are taken. This one is free.'],
  ])('says which are taken', (taken, sentence) => {
    expect(takenSentence({ shape: 1, colour: 1 }, taken)).toBe(sentence);
  });

  it('says who has the same one', () => {
    expect(takenSentence({ shape: 2, colour: 2 }, [IDA, THEO])).toBe(
      'Theo is the blue triangle, too.',
    );
    expect(takenSentence({ shape: 4, colour: 4 }, [LEO])).toBe(
      'Another person is the green star, too.',
    );
  });
});
