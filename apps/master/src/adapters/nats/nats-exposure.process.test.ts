import { startNats } from '@ubii/harness';
import { describe, expect, it, onTestFinished } from 'vitest';

import { openTestLink } from '../../testing/nats-bench.ts';
import { RecordingLog } from '../../testing/recording-log.ts';
import { parseCluster } from '../config/cluster-address.ts';
import { requireTls, watchExposure } from './nats-exposure.ts';

/** Connects to a server of these arguments, over loopback. */
async function linkTo(args: readonly string[], login = '', host = '127.0.0.1') {
  const server = await startNats({ host, args });
  onTestFinished(() => server.stop());
  const url = `nats://${login}127.0.0.1:${server.port}`;
  const log = new RecordingLog();
  const link = await openTestLink(url, log);
  onTestFinished(() => link.close());
  const watch = (isAccepted = false) =>
    watchExposure(link, { address: parseCluster(url), authorities: undefined, isAccepted });
  const warnings = () => log.lines.filter(({ level }) => level === 'warn').map(messageOf);
  return { server, link, watch, warnings };
}

const messageOf = ({ message }: { readonly message: string }): string => message;
const LOGIN = ['--user', 'ann', '--pass', 'secret'];

describe('[CU-64] a NATS server without a login', () => {
  it('is refused when it listens on a network, with what to do', async () => {
    const { watch } = await linkTo([], '', '0.0.0.0');
    expect(() => watch()).toThrow(
      /admits programs of other machines without a login.*deploy\/nats\.conf.*-a 127\.0\.0\.1.*--cluster-insecure/,
    );
  });

  it('is used with a warning where the operator accepts it', async () => {
    const { watch, warnings } = await linkTo([], '', '0.0.0.0');
    watch(true);
    expect(warnings()).toEqual([expect.stringContaining('programs of other machines')]);
  });

  it('is used with a warning on this machine alone, again after each connection', async () => {
    const { server, link, watch, warnings } = await linkTo([]);
    watch();
    expect(warnings()).toEqual([expect.stringMatching(/of this machine .* of any user/)]);
    const isBack = new Promise<void>((resolve) => {
      link.onReach((isConnected) => {
        if (isConnected) resolve();
      });
    });
    await server.restart();
    await isBack;
    expect(warnings().filter((text) => text.includes('of this machine'))).toHaveLength(2);
  });

  it('is not meant by a server with a login, wherever it listens', async () => {
    const { watch, warnings } = await linkTo(LOGIN, 'ann:secret@', '0.0.0.0');
    watch();
    expect(warnings()).toEqual([]);
  });
});

describe('[CU-64] a NATS server without TLS', () => {
  const require = (urls: string, authorities?: string, isAccepted = false) => {
    const exposure = { address: parseCluster(urls), authorities, isAccepted };
    return (): void => requireTls(exposure);
  };

  it('is refused on another machine, before the login is sent', () => {
    expect(require('nats://ann:secret@127.0.0.1,nats://ann:secret@10.0.0.7')).toThrow(
      /NATS at nats:\/\/10\.0\.0\.7:4222 is used without TLS.*tls:\/\/.*--cluster-insecure/,
    );
    expect(require('nats://nats.example.org')).toThrow('without TLS');
  });

  it('is used on this machine, and elsewhere with TLS or where the operator accepts it', () => {
    expect(require('nats://127.0.0.1,nats://localhost:4333,nats://[::1]')).not.toThrow();
    expect(require('tls://10.0.0.7')).not.toThrow();
    expect(require('nats://10.0.0.7', 'PEM')).not.toThrow();
    expect(require('nats://10.0.0.7', undefined, true)).not.toThrow();
  });
});
