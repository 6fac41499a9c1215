import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { probeChannel } from './probe-channel.ts';

/** Socket whose messages the test provides. */
class FakeSocket {
  readonly sent: string[] = [];
  isClosed = false;
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: (() => void) | null = null;
  onerror: (() => void) | null = null;

  send(text: string): void {
    this.sent.push(text);
  }

  close(): void {
    this.isClosed = true;
  }

  /** Replies to the newest request after `afterMs`, with a clock that is ahead by `offsetMs`. */
  answer(afterMs: number, offsetMs: number): void {
    vi.advanceTimersByTime(afterMs);
    this.onmessage?.({ data: `${this.sent.at(-1)} ${Date.now() - afterMs / 2 + offsetMs}` });
  }
}

describe('a try of the live channel [AC-29]', () => {
  let socket: FakeSocket;
  const probe = () => {
    let url = '';
    const done = probeChannel('https://10.0.0.2:8080', (wanted) => {
      url = wanted;
      return (socket = new FakeSocket()) as unknown as WebSocket;
    });
    return { url: () => url, done };
  };

  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('asks five times, and believes the quickest answer', async () => {
    const { url, done } = probe();
    expect(url()).toBe('wss://10.0.0.2:8080/preflight');
    socket.onopen?.();
    for (const [tripMs, offsetMs] of [
      [40, 15],
      [8, 2000],
      [90, -30],
      [20, 7],
      [12, 1],
    ] as const) {
      socket.answer(tripMs, offsetMs);
    }
    expect(await done).toEqual({ isOpen: true, roundTripMs: 8, offsetMs: 2000, errorMs: 4 });
    expect([socket.sent, socket.isClosed]).toEqual([['1', '2', '3', '4', '5'], true]);
  });

  it('is refused when the socket closes before it said anything', async () => {
    const { done } = probe();
    socket.onclose?.();
    expect(await done).toEqual({ isOpen: false, reason: 'refused' });
  });

  it('is silent when nothing comes, opened or not, and what comes is no answer', async () => {
    for (const isOpened of [false, true]) {
      const { done } = probe();
      if (isOpened) {
        socket.onopen?.();
        for (const data of ['hello', '7 1', '1', '1 x']) socket.onmessage?.({ data });
      }
      vi.advanceTimersByTime(6000);
      expect(await done).toEqual({ isOpen: false, reason: 'silent' });
      expect(socket.isClosed).toBe(true);
    }
  });

  it('goes by what came, when the channel breaks half-way', async () => {
    const { done } = probe();
    socket.onopen?.();
    socket.answer(10, 0);
    socket.onclose?.();
    expect(await done).toMatchObject({ isOpen: true, roundTripMs: 10 });
  });
});
