import { describe, expect, it } from 'vitest';

import { ServerProcess } from './server-process.ts';

/** Starts a program of Node, given as source text. */
function start(source: string): Promise<ServerProcess> {
  return ServerProcess.start({ name: 'The test', command: [process.execPath, '-e', source] });
}

describe('a server process', () => {
  it('stops a program with SIGTERM', async () => {
    const server = await start("console.log('{}'); setInterval(() => {}, 1000)");
    await server.stop();
    expect(server.ending).toBe('ended by SIGTERM');
  });

  it('does not pass the settings of the user on', async () => {
    process.env['UBII_HARNESS_TEST'] = '1';
    const server = await start(
      'console.log(JSON.stringify({ names: Object.keys(process.env) })); setInterval(() => {}, 1000)',
    );
    delete process.env['UBII_HARNESS_TEST'];
    expect(server.ready['names']).not.toContain('UBII_HARNESS_TEST');
    await server.end();
  });

  it('fails when the program does not exist', async () => {
    const missing = ServerProcess.start({ name: 'The test', command: ['/no/program'] });
    await expect(missing).rejects.toThrow('The test cannot be started');
  });
});
