import { ClientState, StatusEventKind, type StatusEvent } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aClient } from '../testing/a-client.ts';
import { Comings, comingWords } from './comings.ts';

const anna = aClient('a', { name: 'Anna' });
const robot = aClient('r', { name: 'Robot' });

describe('Comings', () => {
  it('reports clients that left, and clients that resumed', () => {
    const comings = new Comings();
    expect(comings.next([anna, robot])).toEqual([]);
    expect(comings.next([anna])).toEqual([{ kind: 'left', clientId: 'r', name: 'Robot' }]);
    expect(comings.next([anna, robot])).toEqual([{ kind: 'back', clientId: 'r', name: 'Robot' }]);
  });

  it('distinguishes lost clients from those that left [EX-55]', () => {
    const comings = new Comings();
    comings.next([anna, robot]);
    const lost = { ...robot, state: ClientState.UNAVAILABLE };
    expect(comings.next([anna, lost])).toEqual([{ kind: 'lost', clientId: 'r', name: 'Robot' }]);
    expect(comings.next([anna, robot])).toEqual([{ kind: 'back', clientId: 'r', name: 'Robot' }]);
    comings.next([anna, lost]);
    expect(comings.next([anna])).toEqual([]); // Removed from the list, which is not reported again.
  });

  it('reports the return of a client that was lost before the first list', () => {
    const comings = new Comings();
    comings.next([anna, { ...robot, state: ClientState.UNAVAILABLE }]);
    expect(comings.next([anna, robot])).toEqual([{ kind: 'back', clientId: 'r', name: 'Robot' }]);
  });

  it('recognises a new client by the name of one that left, once', () => {
    const comings = new Comings();
    comings.next([robot]);
    comings.next([]);
    const again = aClient('r2', { name: 'Robot' });
    expect(comings.next([again])).toEqual([
      { kind: 'back', clientId: 'r2', name: 'Robot', isNew: true },
    ]);
    expect(comings.next([again, aClient('r3', { name: 'Robot' })])).toEqual([]);
  });
});

describe('comingWords', () => {
  const event = { clientId: 'r', timeMs: 1, text: 'Robot was disconnected by Mara: too loud' };

  it('names the admin who disconnected it', () => {
    const left = { kind: 'left', clientId: 'r', name: 'Robot' } as const;
    const disconnected: StatusEvent = { ...event, kind: StatusEventKind.CLIENT_DISCONNECTED };
    expect(comingWords(left, [])).toBe('Robot has left.');
    expect(comingWords(left, [disconnected])).toBe('Robot was disconnected by Mara: too loud.');
  });

  it('says that a connection broke', () => {
    expect(comingWords({ kind: 'lost', clientId: 'r', name: 'Robot' }, [])).toBe(
      'Robot lost its connection.',
    );
  });

  it('says that it is back', () => {
    const back = { kind: 'back', clientId: 'r', name: 'Robot' } as const;
    expect(comingWords(back, [])).toBe('Robot reconnected.');
    expect(comingWords({ ...back, isNew: true }, [])).toContain('as a new client');
  });
});
