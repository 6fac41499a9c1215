import { ConfigError } from '@ubii/program';
import { execFileSync, spawn } from 'node:child_process';
import { createSocket } from 'node:dgram';
import { announceMaster } from '@ubii/discovery';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, onTestFinished } from 'vitest';
import { discoverMaster } from '@ubii/client-program';
import { masterProgram, nodeProgram } from './build-programs.ts';

const TIMEOUT_MS = 60_000;
const LOOPBACK = '127.0.0.1';

/** A network namespace of this test with one interface. */
const NETWORK = [
  'ip link set lo up',
  'ip link add eth0 type veth peer name end0',
  'ip address add 10.99.0.1/24 dev eth0',
  'ip link set eth0 up && ip link set end0 up',
  'ip route add default dev eth0',
].join(' && ');

function canMakeNetworks(): boolean {
  try {
    execFileSync('unshare', ['-rn', 'sh', '-c', NETWORK], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}

const canIsolate = canMakeNetworks();
if (!canIsolate) console.warn('No network namespaces here: mDNS is tested on loopback only.');

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const socket = createSocket('udp4').bind(0, LOOPBACK, () => {
      const { port } = socket.address();
      socket.close(() => resolve(port));
    });
  });
}

describe.skipIf(!canIsolate)('--discover [DI-5]', { timeout: TIMEOUT_MS }, () => {
  it('finds the built master in a network, and the master exits with code 0 [DI-1] [DI-4]', async () => {
    const folder = temporaryFolder();
    const script = [
      NETWORK,
      `"$0" ${masterProgram} --host 10.99.0.1 --port 8080 --legacy-ports off --data-dir ${folder} & m=$!`,
      `"$0" ${nodeProgram} --discover --identity off 2>&1 & n=$!`,
      'read stop; kill -TERM $m; wait $m; echo "master ended with $?"; kill $n',
    ].join('\n');
    const shell = spawn('unshare', ['-rn', 'sh', '-c', script, process.execPath], {
      stdio: ['pipe', 'pipe', 'pipe'],
      env: { PATH: process.env['PATH'], HOME: folder },
    });
    const ended = new Promise((resolve) => shell.once('close', resolve));
    onTestFinished(async () => {
      shell.stdin.end();
      await ended;
    });
    let text = '';
    const says = (wanted: RegExp): Promise<void> =>
      new Promise((resolve, reject) => {
        const look = (): void => {
          if (wanted.test(text)) resolve();
        };
        for (const stream of [shell.stdout, shell.stderr]) stream.on('data', look);
        shell.once('close', () => reject(new Error(text)));
        look();
      });
    for (const stream of [shell.stdout, shell.stderr]) stream.on('data', (data) => (text += data));
    await says(/announced in the local network/);
    await says(/Found ".*" \(\d.*\) at http:\/\/10\.99\.0\.1:8080/);
    shell.stdin.write('stop\n');
    await says(/master ended with 0/);
  });
});

describe('search for a master [DI-5]', { timeout: TIMEOUT_MS }, () => {
  it('uses the only master, and lists several masters', async () => {
    const port = await freePort();
    const where = { addresses: () => [LOOPBACK], port };
    const announce = (name: string, id: string) => {
      const announced = announceMaster({
        ...where,
        announcement: {
          name,
          id,
          version: '1.2.3',
          https: false,
          port: 8080,
          servicesPort: 8080,
          topicDataPort: 8080,
        },
        host: 'here.local',
        onProblem: () => undefined,
      });
      onTestFinished(() => announced.close());
    };
    const lines: string[] = [];
    announce('Workshop', 'aaaa');
    expect(await discoverMaster((_, line) => lines.push(line), where)).toBe(
      `http://${LOOPBACK}:8080`,
    );
    expect(lines).toContain(`Found "Workshop" (1.2.3) at http://${LOOPBACK}:8080`);
    announce('Lab', 'bbbb');
    const all = discoverMaster(() => undefined, where).catch((error: unknown) => error);
    const error = (await all) as ConfigError;
    expect(error).toBeInstanceOf(ConfigError);
    expect(error.message).toMatch(/2 masters.*--master[^]*"Workshop"/);
    expect(error.message).toContain('"Lab"');
  });
});
