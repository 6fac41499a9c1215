import { LogLevel, type Init, type LogRequest } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { LogTail } from '../src/index.ts';
import { RecordingLog, TestMaster } from '../src/testing/index.ts';

async function read(master: TestMaster, logRequest: Init<LogRequest> = { level: 2 }) {
  const { logTail } = await master.call({ topic: '/services/ubii/log_tail', logRequest });
  return logTail!;
}

const messages = ({ lines }: Awaited<ReturnType<typeof read>>) =>
  lines.map(({ message }) => message);

describe('the log tail', () => {
  it('has the lines after a cursor, down to a level [EX-37]', async () => {
    const master = new TestMaster();
    const { cursor } = await read(master);
    master.logTail.warn('a disk is full', { disk: 'sda', percent: 99 });
    master.logTail.info('all is well');
    const tail = await read(master, { cursor, level: LogLevel.LOG_WARN });
    expect(tail).toMatchObject({ reset: false, missed: 0 });
    expect(tail.lines).toMatchObject([
      {
        timeMs: master.clock.nowMs(),
        level: LogLevel.LOG_WARN,
        message: 'a disk is full',
        fields: [
          { name: 'disk', value: 'sda' },
          { name: 'percent', value: '99' },
        ],
      },
    ]);
    expect(messages(await read(master, { cursor, level: LogLevel.LOG_INFO }))).toHaveLength(2);
    expect(messages(await read(master, { cursor: tail.cursor, level: 3 }))).toEqual([]);
  });

  it('starts over with a cursor of another run [EX-37]', async () => {
    const master = new TestMaster();
    const { cursor, reset } = await read(master, { cursor: 12, level: 2 });
    expect(reset).toBe(true);
    master.clock.advanceSync(1_000);
    const next = new TestMaster({ clock: master.clock });
    expect(await read(next, { cursor, level: 2 })).toMatchObject({ reset: true });
  });

  it('keeps the last 1000 lines, and says how many are missing [EX-37]', async () => {
    const master = new TestMaster();
    const { cursor } = await read(master);
    for (let i = 0; i < 1500; i++) master.logTail.info(`line ${i}`);
    const tail = await read(master, { cursor, level: 2 });
    expect(tail.lines).toHaveLength(1000);
    expect(tail.missed).toBe(500);
    const last = await read(master, { cursor, level: 2, count: 2 });
    expect(messages(last)).toEqual(['line 1498', 'line 1499']);
    expect(last.missed).toBe(1498);
    expect((await read(master, { cursor: cursor + 1400, level: 2 })).missed).toBe(0);
  });

  it('shows no secrets, no stacks and nothing endless [EX-37] [EX-39]', async () => {
    const master = new TestMaster();
    master.logTail.child({ apiKey: 'k1', where: 'x' }).error('GET /?token=abc&a=1 failed', {
      resumeToken: 't',
      stack: 'at main.ts',
      url: 'ws://x/?token=abc&clientID=1',
      long: 'y'.repeat(5000),
    });
    const { lines } = await read(master);
    const line = lines.at(-1)!;
    expect(line.message).toBe('GET /?token=***&a=1 failed');
    expect(line.fields).toEqual([
      { name: 'apiKey', value: '***' },
      { name: 'where', value: 'x' },
      { name: 'resumeToken', value: '***' },
      { name: 'url', value: 'ws://x/?token=***&clientID=1' },
      { name: 'long', value: 'y'.repeat(1000) },
    ]);
  });

  it('has debug lines only where they are written [EX-38]', () => {
    const debugLines = (keepsDebug: boolean): number => {
      const tail = new LogTail(new RecordingLog(), () => 1, keepsDebug);
      tail.debug('a socket failed');
      return tail.read(0, LogLevel.LOG_DEBUG, 0).lines!.length;
    };
    expect([debugLines(false), debugLines(true)]).toEqual([0, 1]);
  });

  it('logs clients that join and leave', async () => {
    const master = new TestMaster();
    await master.extension('Ada');
    expect(messages(await read(master)).slice(-1)).toEqual(['Ada joined']);
  });

  it('takes a count that makes sense', async () => {
    const { error } = await new TestMaster().call({
      topic: '/services/ubii/log_tail',
      logRequest: { count: -1 },
    });
    expect(error?.code).toBe('invalid_argument');
  });
});
