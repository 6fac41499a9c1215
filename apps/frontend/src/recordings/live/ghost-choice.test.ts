import { describe, expect, it } from 'vitest';
import { copiesError, ghostRequest, jitterError } from './ghost-choice.ts';

describe('a ghost', () => {
  it('plays the span in a loop, as many times as chosen', () => {
    const choice = { name: ' Visitor ', copies: '3', jitterMs: '250' };
    expect(ghostRequest(choice, 'r', { fromMs: 10, untilMs: 20 })).toEqual({
      recordingId: 'r',
      isGhost: true,
      isLooping: true,
      name: 'Visitor',
      span: { fromMs: 10, untilMs: 20 },
      copies: 3,
      jitterMs: 250,
    });
  });

  it('has 1 to 32 copies and a jitter that is no negative time', () => {
    for (const copies of ['1', '32']) expect(copiesError({ copies })).toBeUndefined();
    for (const copies of ['0', '33', '1.5', 'x', ''])
      expect(copiesError({ copies })).toMatch(/whole number/);
    expect(jitterError({ jitterMs: '0' })).toBeUndefined();
    expect(jitterError({ jitterMs: '-1' })).toMatch(/time/);
  });
});
