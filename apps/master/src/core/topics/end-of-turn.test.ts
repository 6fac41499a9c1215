import { describe, expect, it } from 'vitest';
import { FakeClock } from '../../testing/fake-clock.ts';
import { EndOfTurn } from './end-of-turn.ts';

function setup() {
  const clock = new FakeClock();
  const endOfTurn = new EndOfTurn(clock);
  const flushed: string[] = [];
  const touch = (name: string): void => endOfTurn.touch({ flush: () => flushed.push(name) });
  return { clock, endOfTurn, flushed, touch };
}

describe('the end of a turn', () => {
  it('flushes when the turn ends, in the order of the touches [TD-30]', () => {
    const { clock, flushed, touch } = setup();
    touch('a');
    touch('b');
    expect(flushed).toEqual([]);
    clock.endTurn();
    expect(flushed).toEqual(['a', 'b']);
  });

  it('comes with the end of the input of one who alone sends [TD-30]', () => {
    const { clock, endOfTurn, flushed, touch } = setup();
    const sender = {};
    endOfTurn.beginRead(sender);
    touch('first');
    endOfTurn.endRead();
    expect(flushed).toEqual([]); // The collector does not know yet that only one client sends.
    clock.endTurn();

    endOfTurn.beginRead(sender);
    touch('second');
    touch('third');
    endOfTurn.endRead();
    expect(flushed).toEqual(['first', 'second', 'third']);
  });

  it('is waited for while several send, and with what is already there [TD-30]', () => {
    const { clock, endOfTurn, flushed, touch } = setup();
    const [one, other] = [{}, {}];
    for (const sender of [one, other, one]) {
      endOfTurn.beginRead(sender);
      touch('turn');
      endOfTurn.endRead();
    }
    expect(flushed).toEqual([]);
    endOfTurn.beginRead(one);
    touch('turn');
    endOfTurn.endRead();
    expect(flushed).toEqual([]); // The turn of the others is not over.
    clock.endTurn();
    expect(flushed).toHaveLength(4);
  });
});
