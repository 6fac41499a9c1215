import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { BRIDGE_LIMITS } from '../limits.ts';
import { EchoMemory } from './echo-memory.ts';

describe('what may come back [BR-23]', () => {
  it('is found once for each time it was sent', () => {
    const memory = new EchoMemory(new FakeClock());
    memory.handleSent('a', 'x');
    memory.handleSent('a', 'x');
    const found = ['a', 'b', 'a', 'a'].map((address) => memory.takeEcho(address, 'x'));
    expect(found).toEqual([true, false, true, false]);
    expect(memory.size).toBe(0);
  });

  it('is forgotten with time, also when nothing of it ever came back', () => {
    const clock = new FakeClock();
    const memory = new EchoMemory(clock);
    memory.handleSent('a', 'x');
    memory.handleSent('b', 'x');
    clock.advanceSync(BRIDGE_LIMITS.echoMs - 1);
    memory.handleSent('a', 'x');
    clock.advanceSync(2);
    // One of each is too old; that of `a` goes with the newer one.
    expect(memory.size).toBe(2);
    expect(memory.takeEcho('b', 'x')).toBe(false);
    expect([memory.takeEcho('a', 'x'), memory.takeEcho('a', 'x')]).toEqual([true, false]);
    expect(memory.size).toBe(0);
  });

  it('is a limited number of messages', () => {
    const memory = new EchoMemory(new FakeClock());
    for (let index = 0; index <= BRIDGE_LIMITS.rememberedEchoes; index++) {
      memory.handleSent('a', String(index));
    }
    expect(memory.size).toBe(BRIDGE_LIMITS.rememberedEchoes);
    expect(memory.takeEcho('a', '0')).toBe(false);
  });
});
