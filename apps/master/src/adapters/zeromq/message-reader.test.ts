import { describe, expect, it } from 'vitest';
import { FrameReader, MessageReader } from './message-reader.ts';
import { DELIMITER, ZmtpError, encodeCommand, encodeFrame, MORE } from './zmtp-frames.ts';
import { SuiteHost } from '../../testing/acceptance/suite-host.ts';
import { LOCAL_CALLER } from '../../index.ts';
import { RecordingConnection } from '../../testing/index.ts';
import { answersOn } from './answer-command.ts';

const MAX_BYTES = 1_000;

/** What a reader finds in these chunks: bodies as text, with `+` where more follows and `!` for commands. */
function found(chunks: readonly Uint8Array[]): string[] {
  const reader = new FrameReader(MAX_BYTES);
  const frames: string[] = [];
  for (const chunk of chunks) {
    reader.read(Buffer.from(chunk), ({ isCommand, hasMore }, bytes, start, end) => {
      const text = bytes.toString('latin1', start, end);
      frames.push(`${text}${hasMore ? '+' : ''}${isCommand ? '!' : ''}`);
    });
  }
  return frames;
}

const sent = Buffer.concat([
  DELIMITER,
  encodeFrame(Buffer.from('short')),
  encodeCommand('PING', Buffer.from('xx')),
  encodeFrame(Buffer.alloc(300, 'l')),
  encodeFrame(Buffer.alloc(0)),
]);
const expected = ['+', 'short', '\x04PINGxx!', 'l'.repeat(300), ''];

describe('frames of ZMTP', () => {
  it('are found in one piece', () => {
    expect(found([sent])).toEqual(expected);
  });

  it.each(Array.from({ length: sent.length - 1 }, (_, i) => i + 1))(
    'are found in two pieces, cut at byte %i',
    (at) => {
      expect(found([sent.subarray(0, at), sent.subarray(at)])).toEqual(expected);
    },
  );

  it('are found byte by byte', () => {
    expect(found([...sent].map((byte) => Uint8Array.of(byte)))).toEqual(expected);
  });

  it('may have the most bytes and no more, which is known from the header', () => {
    expect(found([encodeFrame(Buffer.alloc(MAX_BYTES, 'x'))])).toEqual(['x'.repeat(MAX_BYTES)]);
    const header = encodeFrame(Buffer.alloc(MAX_BYTES + 1)).subarray(0, 9);
    expect(() => found([header])).toThrow('A message may have at most 1000 bytes.');
    expect(() => found([Buffer.from([2, ...Array<number>(8).fill(0xff)])])).toThrow(ZmtpError);
  });

  it('have less when they are commands, which is known from the header [TD-53]', () => {
    const long = (size: number): Buffer => {
      const header = Buffer.alloc(9);
      header[0] = 0x06;
      header.writeUInt32BE(size, 5);
      return header;
    };
    expect(() => found([long(256)])).toThrow('A command may have at most 255 bytes.');
    expect(found([long(255), Buffer.alloc(255, 'c')])).toEqual([`${'c'.repeat(255)}!`]);
  });

  it.each([0x08, 0x80, 0xff, 0x05, 0x07])('have no flags %i', (flags) => {
    expect(() => found([Uint8Array.of(flags)])).toThrow(`unknown flags ${flags}`);
  });
});

/** Calls of the master for these frames, and replies of the protocol. */
async function heard(...frames: Uint8Array[]) {
  const host = new SuiteHost();
  const claim = { clientId: 'ada', token: undefined };
  const handle = host.openConnection(claim, new RecordingConnection(), LOCAL_CALLER)!;
  const answers: Buffer[] = [];
  const reader = new MessageReader(handle, 1_000, (answer) => answers.push(answer));
  reader.read(Buffer.concat(frames));
  return { told: (await host.nextOpened()).heard.waiting, answers };
}

const topicData = (...bytes: number[]) => ({ kind: 'topic data', bytes: Uint8Array.from(bytes) });
const problem = { kind: 'protocol error', reason: expect.stringContaining('more than one frame') };
const frame = (text: string, flags: 0 | typeof MORE = 0): Buffer =>
  encodeFrame(Buffer.from(text), flags);

describe('messages of a DEALER', () => {
  it('are one frame, with or without an empty one in front: pitfall 15 [TD-51]', async () => {
    const content = encodeFrame(Uint8Array.of(1, 2));
    const { told } = await heard(content, DELIMITER, content, encodeFrame(new Uint8Array()));
    expect(told).toEqual([topicData(1, 2), topicData(1, 2), topicData()]);
  });

  it.each([
    ['two frames with content', [frame('a', MORE), frame('b')]],
    ['three frames', [DELIMITER, DELIMITER, frame('b')]],
    ['eight frames', [...Array<Buffer>(7).fill(DELIMITER), frame('b')]],
  ])('are a protocol error as %s, and the next one counts', async (_name, frames) => {
    const { told } = await heard(...frames, encodeFrame(Uint8Array.of(7)));
    expect(told).toEqual([problem, topicData(7)]);
  });

  it('end the connection when their frames do not end [TD-51]', async () => {
    const endless = [...Array<Buffer>(8).fill(frame('a', MORE))];
    await expect(heard(...endless)).rejects.toThrow(ZmtpError);
    await expect(heard(...endless)).rejects.toThrow('more than 8 frames');
  });

  it('are heartbeats when they begin as one [TD-2]', async () => {
    const { told } = await heard(frame('PING'), DELIMITER, frame('PONG'), frame('PING 17'));
    expect(told).toEqual([
      { kind: 'ping' },
      { kind: 'pong' },
      { kind: 'ping', timed: { number: '17', clock: undefined } },
    ]);
    const others = await heard(frame('PINGS'), frame('PIN'));
    expect(others.told.map(({ kind }) => kind)).toEqual(['protocol error', 'topic data']);
  });

  it('may stand between commands: PING of the protocol is answered, others are not [TD-53]', async () => {
    const ping = encodeCommand('PING', Buffer.from('\0\x0acontext'));
    const other = encodeCommand('OTHER', Buffer.from('data'));
    const { told, answers } = await heard(DELIMITER, ping, other, encodeFrame(Uint8Array.of(1)));
    expect(told).toEqual([topicData(1)]);
    expect(answers).toEqual([encodeCommand('PONG', Buffer.from('context'))]);
    await expect(heard(Uint8Array.of(4, 0))).rejects.toThrow(ZmtpError);
    await expect(heard(Uint8Array.of(4, 2, 9, 65))).rejects.toThrow('A command has no name.');
  });
});

it('leaves a peer that takes no answers without more of them [TD-53]', () => {
  const written: Buffer[] = [];
  const socket = {
    writableLength: 0,
    write(bytes: Buffer | string) {
      written.push(Buffer.from(bytes as Buffer));
      this.writableLength += bytes.length;
      return true;
    },
  };
  const answer = answersOn(socket);
  const pong = encodeCommand('PONG', Buffer.alloc(16));
  for (let i = 0; i < 100_000; i++) answer(pong);
  expect(written.length).toBe(Math.ceil((64 * 1024) / pong.length));
});
