import { describe, expect, it } from 'vitest';
import { mappingOf } from '../../testing/mapping-of.ts';
import { BRIDGE_LIMITS } from '../limits.ts';
import { WaitingMessages } from './waiting-messages.ts';

const mapping = mappingOf('out', 'a/{1}', '/a/*');
const message = (address: string) => ({ address, mapping, payload: new Uint8Array() });

describe('messages that wait for the connection [BR-32]', () => {
  it('are the newest of each address, in the order in which they came', () => {
    const dropped: string[] = [];
    const waiting = new WaitingMessages<Uint8Array>(({ address }) => dropped.push(address));
    for (const address of ['a/x', 'a/y', 'a/x']) waiting.add(message(address), 1);
    expect(dropped).toEqual(['a/x']);
    expect(waiting.takeAll().map(({ address }) => address)).toEqual(['a/y', 'a/x']);
    expect(waiting.count).toBe(0);
  });

  it('are bounded by number and by size; the oldest are dropped', () => {
    const dropped: string[] = [];
    const waiting = new WaitingMessages<Uint8Array>(({ address }) => dropped.push(address));
    for (let index = 0; index <= BRIDGE_LIMITS.waitingMessages; index++) {
      waiting.add(message(`a/${index}`), 1);
    }
    expect(dropped).toEqual(['a/0']);
    waiting.add(message('a/large'), BRIDGE_LIMITS.waitingBytes);
    expect(waiting.count).toBe(1);
    expect(waiting.add(message('a/larger'), BRIDGE_LIMITS.waitingBytes + 1).kind).toBe('dropped');
  });
});
