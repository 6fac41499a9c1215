import { describe, expect, it } from 'vitest';
import { FakeClock } from '../testing/fake-clock.ts';
import { Link, PING_INTERVAL_MS } from './link.ts';
import type { LinkFailure } from './link-failure.ts';
import type { TopicDataHandler } from './ports/topic-data-transport.ts';

function setup({ canPing = true } = {}) {
  const clock = new FakeClock();
  const sent: string[] = [];
  const closes: number[] = [];
  const ends: LinkFailure[] = [];
  const roundTripsMs: number[] = [];
  const unknown: string[] = [];
  let handler!: TopicDataHandler;
  const link = new Link({
    transport: {
      open(_query, opened) {
        handler = opened;
        return {
          sendBinary: (bytes) => sent.push(`${bytes.byteLength} bytes`),
          sendText: (text) => sent.push(text),
          bufferedBytes: 7,
          close: (code = 1000) => closes.push(code),
        };
      },
    },
    query: { clientId: 'ada', resumeToken: 'token' },
    clock,
    canPing,
    openTimeoutMs: 1_000,
    handleBinary: () => undefined,
    handleUnknownText: (text) => unknown.push(text),
    handleRoundTrip: (ms) => roundTripsMs.push(ms),
    handleEnd: (failure) => ends.push(failure),
  });
  return { clock, link, handler, sent, closes, ends, roundTripsMs, unknown };
}

describe('Link to a master of ours', () => {
  it('is up when the first PONG has come, not when the socket opens', async () => {
    const { link, handler, sent, clock, roundTripsMs } = setup();
    handler.handleOpen();
    expect(sent).toEqual(['PING']);
    expect(link.isUp).toBe(false);
    await clock.advance(3);
    handler.handleText('PONG');
    await link.up;
    expect(link.isUp).toBe(true);
    expect(roundTripsMs).toEqual([3]);
  });

  it('ends with the code the master gives after opening', async () => {
    const { link, handler, ends, clock } = setup();
    handler.handleOpen();
    handler.handleClose(4004, 'unknown client');
    await expect(link.up).rejects.toMatchObject({ code: 4004, wasUp: false });
    await expect(link.ended).rejects.toMatchObject({ code: 4004 });
    expect(ends).toHaveLength(1);
    expect(clock.pendingTimers).toBe(0);
  });

  it('ends when nothing opens in time', async () => {
    const { ends, closes, clock } = setup();
    await clock.advance(1_000);
    expect(ends).toMatchObject([{ error: { reason: 'timeout' }, wasUp: false }]);
    expect(closes).toEqual([1000]);
  });

  it('ends when it opens and does not answer in time', async () => {
    const { handler, ends, clock } = setup();
    handler.handleOpen();
    await clock.advance(1_000);
    expect(ends).toMatchObject([{ error: { reason: 'timeout' }, wasUp: false }]);
  });

  it('measures every 2 s [EX-6]', async () => {
    const { handler, sent, clock, roundTripsMs } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    await clock.advance(PING_INTERVAL_MS);
    expect(sent).toEqual(['PING', 'PING']);
    await clock.advance(5);
    handler.handleText('PONG');
    expect(roundTripsMs).toEqual([0, 5]);
  });

  it('is dead after three PINGs without any frame', async () => {
    const { handler, ends, clock } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    await clock.advance(PING_INTERVAL_MS * 3);
    expect(ends).toEqual([]);
    await clock.advance(PING_INTERVAL_MS);
    expect(ends).toMatchObject([{ error: { reason: 'timeout' }, code: 1006, wasUp: true }]);
  });

  it('lives as long as any frame comes', async () => {
    const { handler, ends, clock } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    for (let i = 0; i < 10; i++) {
      await clock.advance(PING_INTERVAL_MS);
      handler.handleBinary(new Uint8Array());
    }
    expect(ends).toEqual([]);
  });

  it('ends when a probe is not answered, and not when it is', async () => {
    const { link, handler, ends, clock } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    link.probe();
    handler.handleText('PONG');
    await clock.advance(2_000);
    expect(ends).toEqual([]);
    handler.handleText('PONG');
    link.probe();
    await clock.advance(2_000);
    expect(ends).toMatchObject([{ error: { reason: 'timeout' } }]);
  });

  it('knows when the master has handled what was sent', async () => {
    const { link, handler } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    let isHandled = false;
    const handled = link.handled().then(() => (isHandled = true));
    await Promise.resolve();
    expect(isHandled).toBe(false);
    handler.handleText('PONG');
    await handled;
  });

  it('does not wait for a master that is gone', async () => {
    const { link, handler } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    const handled = link.handled();
    handler.handleClose(1006, '');
    await handled;
    await link.handled();
  });

  it('answers PING with PONG, and reports other text', () => {
    const { handler, sent, unknown } = setup();
    handler.handleOpen();
    handler.handleText('PING');
    handler.handleText('hello');
    expect(sent).toEqual(['PING', 'PONG']);
    expect(unknown).toEqual(['hello']);
  });

  it('says nothing of its end when it is closed, and ignores what comes after', () => {
    const { link, handler, ends, closes, clock, unknown } = setup();
    handler.handleOpen();
    handler.handleText('PONG');
    link.close();
    link.close();
    handler.handleText('hello');
    handler.handleClose(1000, '');
    expect(closes).toEqual([1000]);
    expect(ends).toEqual([]);
    expect(unknown).toEqual([]);
    expect(clock.pendingTimers).toBe(0);
  });
});

describe('Link to an original master', () => {
  it('is up when the socket opens, and sends no PING', async () => {
    const { link, handler, sent, clock } = setup({ canPing: false });
    handler.handleOpen();
    await link.up;
    await clock.advance(60_000);
    link.probe();
    await link.handled();
    expect(sent).toEqual([]);
    expect(link.isUp).toBe(true);
  });
});
