import { describe, expect, it } from 'vitest';

import { StreamLog } from '../log/stream-log.ts';
import { FaultGuard } from './fault-guard.ts';

function guarded() {
  const lines: string[] = [];
  let givenUp = 0;
  const write = (line: string) => lines.push(line);
  const log = new StreamLog({ level: 'error', format: 'json', write, nowMs: () => 0 });
  return { guard: new FaultGuard(log, () => (givenUp += 1)), lines, timesGivenUp: () => givenUp };
}

describe('uncaught errors', () => {
  it('are logged with their stack and do not end the process', () => {
    const { guard, lines, timesGivenUp } = guarded();
    guard.handle('uncaught error', new Error('oh'), 0);
    guard.handle('unhandled rejection', 'just text', 1);
    expect(lines[0]).toContain('oh');
    expect(lines[0]).toContain('"stack":"Error: oh');
    expect(lines[1]).toContain('just text');
    expect(timesGivenUp()).toBe(0);
  });

  it('end it when they keep coming', () => {
    const { guard, timesGivenUp } = guarded();
    for (let index = 0; index <= 10; index += 1) guard.handle('uncaught error', 'x', index * 100);
    expect(timesGivenUp()).toBe(1);
  });

  it('do not end it when they are rare', () => {
    const { guard, timesGivenUp } = guarded();
    for (let index = 0; index <= 50; index += 1) guard.handle('uncaught error', 'x', index * 2000);
    expect(timesGivenUp()).toBe(0);
  });
});
