import { StatusEventKind, type StatusEvent } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { goneLately } from './gone-lately.ts';

const { CLIENT_JOINED, CLIENT_LEFT, CLIENT_LOST, CLIENT_RETURNED } = StatusEventKind;
const { CLIENT_DISCONNECTED, CLIENT_RENAMED, MASTER_STARTED } = StatusEventKind;

function event(clientId: string, kind: StatusEvent['kind'], timeMs: number): StatusEvent {
  return { clientId, kind, timeMs, text: `${clientId} ${kind}` };
}

describe('goneLately [EX-55]', () => {
  it('distinguishes clients that left, were lost or were removed, latest first', () => {
    const events = [
      event('', MASTER_STARTED, 0),
      event('ada', CLIENT_JOINED, 1),
      event('ben', CLIENT_LOST, 2),
      event('ada', CLIENT_LEFT, 3),
      event('eva', CLIENT_DISCONNECTED, 4),
      event('ada', CLIENT_RENAMED, 5),
    ];
    expect(goneLately(events, () => false)).toMatchObject([
      { clientId: 'eva', how: 'disconnected', atMs: 4 },
      { clientId: 'ada', how: 'left', atMs: 3 },
      { clientId: 'ben', how: 'lost', atMs: 2 },
    ]);
  });

  it('leaves out clients that came back or are still listed', () => {
    const events = [
      event('ada', CLIENT_LEFT, 1),
      event('ben', CLIENT_LOST, 2),
      event('ada', CLIENT_RETURNED, 3),
    ];
    expect(goneLately(events, (id) => id === 'ben')).toEqual([]);
  });
});
