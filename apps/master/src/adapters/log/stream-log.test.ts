import { describe, expect, it } from 'vitest';
import { logSuite, type WrittenLine } from '../../testing/acceptance/index.ts';
import { StreamLog, type LogOptions, LinesAfter } from './stream-log.ts';

function record(options: Partial<LogOptions>) {
  const lines: string[] = [];
  const log = new StreamLog({
    level: 'info',
    format: 'text',
    write: (line) => lines.push(line),
    nowMs: () => Date.UTC(2024, 0, 2, 3, 4, 5, 6),
    ...options,
  });
  return { log, lines };
}

logSuite('StreamLog', () => {
  const { log, lines } = record({ level: 'debug', format: 'json' });
  return { log, lines: () => lines.map(readLine) };
});

function readLine(line: string): WrittenLine {
  const { level, message, ...fields } = JSON.parse(line) as Record<string, unknown>;
  return { level: String(level), message: String(message), fields };
}

describe('the log', () => {
  it('writes JSON for machines', () => {
    const { log, lines } = record({ format: 'json' });
    log.child({ client: 'a' }).warn('refused', { code: 4001, reason: undefined });
    expect(lines.map((line) => JSON.parse(line) as unknown)).toEqual([
      {
        time: '2024-01-02T03:04:05.006Z',
        level: 'warn',
        message: 'refused',
        client: 'a',
        code: 4001,
      },
    ]);
  });

  it('writes text for people', () => {
    const { log, lines } = record({});
    log.info('a client joined', { name: 'My phone', port: 80, none: undefined });
    log.error('failed', { stack: 'Error: x\n    at y' });
    expect(lines).toEqual([
      '03:04:05 info  a client joined name="My phone" port=80',
      '03:04:05 error failed\nError: x\n    at y',
    ]);
  });

  it('keeps what clients send from acting on the terminal', () => {
    const { log, lines } = record({});
    log.info('joined', { name: '\u001b[2Jx\n\u009b1m' });
    // eslint-disable-next-line no-control-regex -- control characters are what must not be there
    expect(lines[0]).not.toMatch(/[\u0000-\u001f\u007f-\u009f]/);
  });

  it('leaves out what is less severe than its level', () => {
    const { log, lines } = record({ level: 'warn' });
    log.debug('a');
    log.info('b');
    log.warn('c');
    log.child({}).error('d');
    expect(lines).toHaveLength(2);
  });
});

it('holds lines until it is opened, and writes them in order', () => {
  const written: string[] = [];
  const lines = new LinesAfter((line) => written.push(line));
  lines.write('one');
  lines.write('two');
  expect(written).toEqual([]);
  written.push('banner');
  lines.open();
  lines.write('three');
  lines.open();
  expect(written).toEqual(['banner', 'one', 'two', 'three']);
});
