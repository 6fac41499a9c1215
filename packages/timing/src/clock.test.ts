import { describe, expect, it } from 'vitest';

import { within, EndOfTurn } from './clock.ts';
import { FakeClock } from './testing/index.ts';

function setUpWait() {
  const clock = new FakeClock();
  let finish = (): void => undefined;
  let fail = (_reason: Error): void => undefined;
  const work = new Promise<void>((resolve, reject) => {
    finish = resolve;
    fail = reject;
  });
  return { clock, waiting: within(clock, 100, work), finish, fail };
}

describe('within', () => {
  it('returns true for work that ends in time, and leaves no timer', async () => {
    const { clock, waiting, finish } = setUpWait();
    await clock.advance(99);
    finish();
    expect(await waiting).toBe(true);
    expect(clock.timerCount).toBe(0);
  });

  it('returns false when the time is over, and ignores a later failure', async () => {
    const { clock, waiting, fail } = setUpWait();
    await clock.advance(100);
    expect(await waiting).toBe(false);
    fail(new Error('too late'));
    await clock.advance(0);
  });

  it('rejects with what the work rejects with, and leaves no timer', async () => {
    const { clock, waiting, fail } = setUpWait();
    fail(new Error('broken'));
    await expect(waiting).rejects.toThrow('broken');
    expect(clock.timerCount).toBe(0);
  });
});

function setUpTurn() {
  const clock = new FakeClock();
  const endOfTurn = new EndOfTurn(clock);
  const run: string[] = [];
  const add = (name: string): void => endOfTurn.add({ handleEndOfTurn: () => run.push(name) });
  return { clock, endOfTurn, run, add };
}

describe('the end of a turn', () => {
  it('runs the tasks when the turn ends, in the order they were added [TD-30]', () => {
    const { clock, run, add } = setUpTurn();
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
    const { clock, endOfTurn, run, add } = setUpTurn();
    endOfTurn.add({ handleEndOfTurn: () => add('next') });
    clock.atEndOfTurn(() => run.push('this'));
    clock.endTurnSync();
    expect(run).toEqual(['this', 'next']);
  });

  it('runs tasks when the input of the only sender ends [TD-30]', () => {
    const { clock, endOfTurn, run, add } = setUpTurn();
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
    const { clock, endOfTurn, run, add } = setUpTurn();
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
