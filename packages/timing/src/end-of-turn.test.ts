import { describe, expect, it } from 'vitest';
import { EndOfTurn } from './end-of-turn.ts';
import { FakeClock } from './testing/index.ts';

function setup() {
  const clock = new FakeClock();
  const endOfTurn = new EndOfTurn(clock);
  const run: string[] = [];
  const add = (name: string): void => endOfTurn.add({ handleEndOfTurn: () => run.push(name) });
  return { clock, endOfTurn, run, add };
}

describe('the end of a turn', () => {
  it('runs the tasks when the turn ends, in the order they were added [TD-30]', () => {
    const { clock, run, add } = setup();
    add('a');
    add('b');
    expect(run).toEqual([]);
    expect(clock.endOfTurnCount).toBe(1);
    clock.endTurnSync();
    expect(run).toEqual(['a', 'b']);
  });

  it('calls the function of its owner before the first task', () => {
    const clock = new FakeClock();
    const order: string[] = [];
    const endOfTurn = new EndOfTurn(clock, () => order.push('end'));
    for (const name of ['a', 'b']) endOfTurn.add({ handleEndOfTurn: () => order.push(name) });
    clock.endTurnSync();
    clock.endTurnSync();
    expect(order).toEqual(['end', 'a', 'b']);
  });

  it('runs a task that another task adds in the next turn', () => {
    const { clock, endOfTurn, run, add } = setup();
    endOfTurn.add({ handleEndOfTurn: () => add('next') });
    clock.atEndOfTurn(() => run.push('this'));
    clock.endTurnSync();
    expect(run).toEqual(['this', 'next']);
  });

  it('runs tasks when the input of the only sender ends [TD-30]', () => {
    const { clock, endOfTurn, run, add } = setup();
    const sender = {};
    endOfTurn.beginRead(sender);
    add('first');
    endOfTurn.endRead();
    expect(run).toEqual([]); // It does not know yet that only one client sends.
    clock.endTurnSync();

    endOfTurn.beginRead(sender);
    add('second');
    add('third');
    endOfTurn.endRead();
    expect(run).toEqual(['first', 'second', 'third']);
  });

  it('runs tasks at the end of the turn while several clients send [TD-30]', () => {
    const { clock, endOfTurn, run, add } = setup();
    const [one, other] = [{}, {}];
    for (const sender of [one, other, one]) {
      endOfTurn.beginRead(sender);
      add('turn');
      endOfTurn.endRead();
    }
    expect(run).toEqual([]);
    endOfTurn.beginRead(one);
    add('turn');
    endOfTurn.endRead();
    expect(run).toEqual([]); // The turn of the others is not over.
    clock.endTurnSync();
    expect(run).toHaveLength(4);
  });
});
