import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { Link, PING_INTERVAL_MS } from './link.ts';
import type { LinkTime } from './link.ts';
import type { LinkFailure } from './link-failure.ts';
import type { TopicDataHandler } from '../ports/topic-data-transport.ts';
import type { TimeExchange } from '../time/time-sample.ts';

function setup({ canPing = true, tellsTime = false } = {}) {
  const clock = new FakeClock();
  const sent: string[] = [];
  const closes: number[] = [];
  const ends: LinkFailure[] = [];
  const roundTripsMs: number[] = [];
  const unknown: string[] = [];
  const exchanges: TimeExchange[] = [];
  const time: LinkTime = {
    handleExchange: (exchange) => exchanges.push(exchange),
    describeClock: () => (exchanges.length === 0 ? '' : '-2.500 0.200 1.0'),
  };
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
    time: tellsTime ? time : undefined,
    handleEnd: (failure) => ends.push(failure),
  });
  return { clock, link, handler, sent, closes, ends, roundTripsMs, unknown, exchanges };
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
    expect(ends).toHaveLength(1);
    expect(clock.timerCount).toBe(0);
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
    expect(clock.timerCount).toBe(0);
  });
});

describe('Link to a master that tells its time', () => {
  it('asks with numbered PINGs, some at once, and then with those it sends anyway [TS-2] [TS-3]', async () => {
    const { handler, sent, clock, exchanges, roundTripsMs } = setup({ tellsTime: true });
    handler.handleOpen();
    expect(sent).toEqual(['PING 1']);
    await clock.advance(4);
    handler.handleText('PONG 1 1767225600001.250 1767225600001.500');
    expect(exchanges).toMatchObject([
      {
        sent: { monotonicMs: 0 },
        received: { monotonicMs: 4 },
        masterReceivedMs: 1767225600001.25,
        masterSentMs: 1767225600001.5,
      },
    ]);
    await clock.advance(PING_INTERVAL_MS - 1);
    expect(sent).toHaveLength(8);
    expect(sent.at(-1)).toBe('PING 8 -2.500 0.200 1.0');
    await clock.advance(1);
    expect(sent).toHaveLength(9);
    handler.handleText('PONG 8 1 1');
    expect(roundTripsMs).toEqual([4]); // those for the clock alone are none
    handler.handleText('PONG 9 1 1');
    expect(roundTripsMs).toEqual([4, 0]);
  });

  it('is not dead because PINGs for the clock stay unanswered', async () => {
    const { link, handler, ends, clock } = setup({ tellsTime: true });
    handler.handleOpen();
    handler.handleText('PONG 1 1 1');
    await clock.advance(PING_INTERVAL_MS);
    handler.handleText('PONG 9 1 1');
    link.measureTime();
    await clock.advance(PING_INTERVAL_MS * 3);
    expect(ends).toEqual([]);
    await clock.advance(PING_INTERVAL_MS);
    expect(ends).toHaveLength(1);
    expect(clock.timerCount).toBe(0);
  });

  it('takes a PONG for that of its PING, whatever was left unanswered', async () => {
    const { link, handler, clock, exchanges } = setup({ tellsTime: true });
    handler.handleOpen();
    handler.handleText('PONG 1 1 1');
    const handled = link.handled(); // PING 2
    await clock.advance(60); // PING 3
    handler.handleText('PONG 3 1 1');
    await handled;
    handler.handleText('PONG 2 1 1');
    handler.handleText('PONG 77 1 1');
    expect(exchanges.map(({ sent }) => sent.monotonicMs)).toEqual([0, 50]);
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
