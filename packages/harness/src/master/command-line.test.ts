import { describe, expect, it } from 'vitest';

import { masterCommand } from './command-line.ts';

const START = { program: 'main.js', dataDir: '/data' };

describe('the command line of a master', () => {
  it('has defaults', () => {
    expect(masterCommand(START, false).join(' ')).toBe(
      `${process.execPath} --enable-source-maps --max-semi-space-size=8 main.js --host 127.0.0.1 --port 0 --legacy-ports off --mdns off --log-format json --data-dir /data --print-endpoints json`,
    );
  });

  it('leaves out defaults that flags replace', () => {
    const command = masterCommand({ ...START, flags: ['--port', '80', '--mdns', 'on'] }, true);
    expect(command.filter((word) => word === '--port' || word === '--mdns')).toHaveLength(2);
    expect(command).toContain('--trust-loopback');
  });

  it('starts elsewhere, with fewer descriptors and a profile', () => {
    const command = masterCommand(
      {
        ...START,
        within: ['ip', 'netns', 'exec', 'a'],
        maxDescriptors: 50,
        profileDir: '/p',
        nodeFlags: ['--expose-gc'],
      },
      false,
    ).join(' ');
    expect(command).toMatch(/^ip netns exec a bash -c ulimit -n 50; exec "\$@" limited /);
    expect(command).toMatch(/--cpu-prof-name=ubii\.cpuprofile .* --expose-gc main\.js/);
  });
});
