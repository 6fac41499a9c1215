import { once } from 'node:events';
import { createServer, type ServerResponse } from 'node:http';
import { connect } from 'node:net';
import { afterEach, describe, expect, it } from 'vitest';

import { StreamLog } from '../log/stream-log.ts';
import { Listeners } from './listeners.ts';
import { openPort } from './open-port.ts';

const opened: { close(): Promise<unknown> }[] = [];
const logged: string[] = [];
const log = new StreamLog({
  level: 'debug',
  format: 'text',
  write: (line) => logged.push(line),
  nowMs: () => 0,
});

afterEach(async () => {
  await Promise.all(opened.splice(0).map((each) => each.close()));
  logged.length = 0;
});

function listeners(): Listeners {
  const created = new Listeners({
    onePort: undefined,
    host: 'localhost',
    log,
    handleRequest: (_request, response) => response.end('hello'),
    handleUpgrade: (_request, socket) => socket.destroy(),
  });
  opened.push(created);
  return created;
}

async function takenPort(): Promise<number> {
  const { port, servers } = await openPort(0, 'localhost', () => createServer());
  opened.push({
    close: () => Promise.all(servers.map((server) => new Promise((done) => server.close(done)))),
  });
  return port;
}

describe('opening ports', () => {
  it('takes any free one, the same on both loopback addresses', async () => {
    const master = listeners();
    await master.open({ main: 0, legacy: undefined, legacyWished: false });
    const { main } = master.ports;
    expect(master.ports).toEqual({ main, services: main, topicData: main });
    for (const host of ['127.0.0.1', 'localhost']) {
      expect(await (await fetch(`http://${host}:${main}`)).text()).toBe('hello');
    }
  });

  it('says what to do about a port that is taken', async () => {
    const port = await takenPort();
    await expect(
      listeners().open({ main: port, legacy: undefined, legacyWished: false }),
    ).rejects.toThrow(
      `Port ${port} (--port) is used by another program: end that program, or choose`,
    );
  });

  it('answers the same on the legacy ports', async () => {
    const master = listeners();
    await master.open({ main: 0, legacy: { services: 0, topicData: 0 }, legacyWished: true });
    const { main, services, topicData } = master.ports;
    expect(new Set([main, services, topicData]).size).toBe(3);
    expect(await (await fetch(`http://127.0.0.1:${services}`)).text()).toBe('hello');
    expect(await (await fetch(`http://127.0.0.1:${topicData}`)).text()).toBe('hello');
  });

  it('leaves a legacy port out that is taken, with a warning', async () => {
    const port = await takenPort();
    const master = listeners();
    await master.open({ main: 0, legacy: { services: port, topicData: 0 }, legacyWished: false });
    expect(master.ports.services).toBe(master.ports.main);
    expect(logged.join()).toContain(`Port ${port} (--legacy-ports) is used`);
  });

  it('fails when a legacy port is taken that was asked for', async () => {
    const port = await takenPort();
    await expect(
      listeners().open({ main: 0, legacy: { services: 0, topicData: port }, legacyWished: true }),
    ).rejects.toThrow(/--legacy-ports off/);
  });

  it('needs no second server for a legacy port that is the main port', async () => {
    const main = await takenPort();
    await opened.pop()?.close();
    const master = listeners();
    await master.open({ main, legacy: { services: main, topicData: main }, legacyWished: true });
    expect(master.ports).toEqual({ main, services: main, topicData: main });
  });

  it('moves to another host on the same ports, and open connections stay', async () => {
    const answers: ServerResponse[] = [];
    const master = new Listeners({
      onePort: undefined,
      host: 'localhost',
      log,
      handleRequest: (request, response) => {
        if (request.url === '/slow') answers.push(response);
        else response.end('hello');
      },
      handleUpgrade: (_request, socket) => socket.destroy(),
    });
    opened.push(master);
    await master.open({ main: 0, legacy: { services: 0, topicData: 0 }, legacyWished: true });
    const { ports } = master;
    const slow = fetch(`http://127.0.0.1:${ports.main}/slow`);
    await expect.poll(() => answers.length).toBe(1);
    // Another loopback address stands for another network.
    await master.move({ host: '127.0.0.2', onePort: undefined });
    expect(master.ports).toEqual(ports);
    for (const port of Object.values(ports)) {
      expect(await (await fetch(`http://127.0.0.2:${port}`)).text()).toBe('hello');
      await expect(fetch(`http://127.0.0.1:${port}`)).rejects.toThrow();
    }
    answers[0]!.end('late');
    expect(await (await slow).text()).toBe('late');
  });

  it('moves the ports of ZeroMQ to another host as well, each with what takes its connections', async () => {
    const master = new Listeners({
      onePort: undefined,
      host: 'localhost',
      log,
      handleRequest: (_request, response) => response.end('hello'),
      handleUpgrade: (_request, socket) => socket.destroy(),
      zeromq: {
        services: (socket) => socket.end('services'),
        topicData: (socket) => socket.end('topic data'),
      },
    });
    opened.push(master);
    const zeromq = { services: 0, topicData: 0 };
    await master.open({ main: 0, legacy: undefined, legacyWished: false, zeromq });
    const { ports } = master;
    const said = async (host: string, port: number): Promise<string> => {
      const socket = connect(port, host).setEncoding('utf8');
      const [text] = (await once(socket, 'data')) as [string];
      return text;
    };
    expect(await said('127.0.0.1', ports.zeromq!.services)).toBe('services');
    await master.move({ host: '127.0.0.2', onePort: undefined });
    expect(master.ports).toEqual(ports);
    expect(await said('127.0.0.2', ports.zeromq!.services)).toBe('services');
    expect(await said('127.0.0.2', ports.zeromq!.topicData)).toBe('topic data');
    await expect(said('127.0.0.1', ports.zeromq!.services)).rejects.toThrow('ECONNREFUSED');
  });

  it('stays where it is when the main port cannot be had on the other host', async () => {
    const master = listeners();
    await master.open({ main: 0, legacy: { services: 0, topicData: 0 }, legacyWished: true });
    const { main, services } = master.ports;
    await expect(master.move({ host: '192.0.2.1', onePort: undefined })).rejects.toThrow(
      'The host "192.0.2.1" (--host) is not an address of this machine',
    );
    for (const port of [main, services]) {
      expect(await (await fetch(`http://127.0.0.1:${port}`)).text()).toBe('hello');
    }
  });

  it('leaves a legacy port where it is that cannot be had on the other host, with a warning', async () => {
    const master = listeners();
    await master.open({ main: 0, legacy: { services: 0, topicData: 0 }, legacyWished: true });
    const { main, services } = master.ports;
    const taken = createServer();
    await new Promise<void>((done) => taken.listen(services, '127.0.0.2', done));
    opened.push({ close: () => new Promise((done) => taken.close(done)) });
    await master.move({ host: '127.0.0.2', onePort: undefined });
    expect(await (await fetch(`http://127.0.0.2:${main}`)).text()).toBe('hello');
    expect(await (await fetch(`http://127.0.0.1:${services}`)).text()).toBe('hello');
    expect(logged.join()).toContain(`Port ${services} (--legacy-ports) is used`);
  });

  it('explains a host that is none of this machine', async () => {
    const elsewhere = new Listeners({
      onePort: undefined,
      host: '192.0.2.1',
      log,
      handleRequest: () => {},
      handleUpgrade: () => {},
    });
    await expect(
      elsewhere.open({ main: 0, legacy: undefined, legacyWished: false }),
    ).rejects.toThrow('The host "192.0.2.1" (--host) is not an address of this machine');
  });
});
