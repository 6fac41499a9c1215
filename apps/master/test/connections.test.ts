import { describe, expect, it } from 'vitest';

import { DEFAULT_LIMITS, fitConnections } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';

const LIMITS = {
  connections: 16,
  connectionsOfStrangers: 8,
  connectionsPerAddress: 4,
  connectionsPerNetwork: 6,
};

/** A master and what connects to it; `cut` has the names of what it closed, in order. */
function world(limits: Partial<typeof DEFAULT_LIMITS> = LIMITS) {
  const master = new TestMaster({ limits });
  const cut: string[] = [];
  let count = 0;
  const connect = (address: string, network = address) => {
    const name = `${address} #${++count}`;
    const peer = { address, network, isLocal: address === '127.0.0.1' };
    return master.master.admitConnection(peer, () => cut.push(name));
  };
  const hits = async (limit: string) => {
    const { limitList } = await master.call({ topic: '/services/ubii/limit_list' });
    const found = limitList!.elements.find(({ name }) => name === limit);
    return { hits: found?.hits, use: found?.use?.value };
  };
  return { master, connect, cut, hits };
}

describe('connections', () => {
  it('[AC-60] have a limit for each address, which is counted and shown', async () => {
    const { connect, cut, hits } = world();
    for (let i = 0; i < 4; i++) expect(connect('10.0.0.1')).toBeDefined();
    expect(connect('10.0.0.1')).toBeUndefined();
    expect(cut).toEqual([]);
    expect(connect('10.0.0.2')).toBeDefined();
    expect(await hits('connectionsPerAddress')).toEqual({ hits: 1, use: 4 });
    expect(await hits('connectionsOfStrangers')).toMatchObject({ use: 5 });
  });

  it('[AC-60] have a limit for each network of IPv6, where the address with most gives way', () => {
    const { connect, cut } = world();
    for (let i = 0; i < 4; i++) connect('fd00::1', 'fd00');
    for (let i = 0; i < 2; i++) connect('fd00::2', 'fd00');
    expect(connect('fd00::3', 'fd00')).toBeDefined();
    expect(cut).toEqual(['fd00::1 #1']);
  });

  it('[AC-61] of one address give way to its next ones when they had time to say who they are', () => {
    const { master, connect, cut } = world();
    for (let i = 0; i < 4; i++) connect('10.0.0.1');
    master.clock.advanceSync(3_000);
    expect(connect('10.0.0.1')).toBeDefined();
    expect(cut).toEqual(['10.0.0.1 #1']);
  });

  it('[AC-61] of an address with many give way to those of one with few', () => {
    const { connect, cut } = world();
    for (let i = 0; i < 4; i++) connect('10.0.0.1');
    for (let i = 0; i < 4; i++) connect('10.0.0.2');
    expect(connect('10.0.0.3')).toBeDefined();
    expect(connect('10.0.0.3')).toBeDefined();
    expect(cut).toHaveLength(2);
    // It would have as many as the others; no new connection is closed for it.
    expect(connect('10.0.0.3')).toBeUndefined();
  });

  it('[AC-62] of this machine find room however many strangers there are', () => {
    const { connect } = world({ ...LIMITS, connectionsOfStrangers: 1_000 });
    for (let i = 0; i < 100; i++) connect(`10.0.1.${i}`);
    expect(connect('10.0.2.1')).toBeUndefined();
    for (let i = 0; i < 16; i++) expect(connect('127.0.0.1')).toBeDefined();
    expect(connect('127.0.0.1')).toBeUndefined();
  });

  it('[AC-62] of those who joined stay, and find room for more, however many strangers there are', () => {
    const { connect, cut } = world();
    const first = connect('10.0.0.9')!;
    first.handleRequest();
    first.handleCaller('client');
    connect('10.0.0.9')!.handleClient();
    for (let i = 0; i < 100; i++) connect(`10.0.1.${i}`);
    expect(connect('10.0.2.1')).toBeUndefined();
    for (let i = 0; i < 3; i++) expect(connect('10.0.0.9')).toBeDefined();
    expect(cut.filter((name) => name.startsWith('10.0.0.9'))).toEqual([]);
  });

  it('[AC-62] of strangers that a proxy of this machine brings have no part in what is kept for it', async () => {
    const { connect, cut, hits } = world({ ...LIMITS, connectionsPerAddress: 100 });
    for (let i = 0; i < 10; i++) connect('127.0.0.1')!.handleCaller('stranger');
    expect(cut).toHaveLength(2);
    expect(await hits('connectionsOfStrangers')).toEqual({ hits: 2, use: 8 });
  });

  it('[AC-63] that say nothing are closed', () => {
    const { master, connect, cut } = world();
    const asked = connect('10.0.0.1')!;
    const local = connect('127.0.0.1')!;
    asked.handleRequest();
    connect('10.0.0.2');
    master.clock.advanceSync(DEFAULT_LIMITS.headersTimeoutMs - 1_000);
    local.handleRequest();
    expect(cut).toEqual([]);
    master.clock.advanceSync(1_000);
    expect(cut).toEqual(['10.0.0.2 #3']);
  });

  it('[AC-60] that end leave nothing behind', async () => {
    const { connect, hits } = world();
    const all = ['10.0.0.1', '10.0.0.1', '127.0.0.1', 'fd00::1'].map((each) => connect(each)!);
    all[0]!.handleCaller('joining');
    all[1]!.handleClient();
    all[2]!.handleCaller('stranger');
    for (const each of [...all, ...all]) each.handleClose();
    for (const limit of Object.keys(LIMITS)) expect(await hits(limit)).toMatchObject({ use: 0 });
    // Reports about closed connections are ignored.
    for (const each of all) each.handleClient();
    for (const limit of Object.keys(LIMITS)) expect(await hits(limit)).toMatchObject({ use: 0 });
  });

  it('[AC-60] are fewer where the process may open less, in the same proportions', () => {
    const fit = (descriptors: number | undefined) => {
      const { connections, connectionsOfStrangers, connectionsPerNetwork, connectionsPerAddress } =
        fitConnections(DEFAULT_LIMITS, descriptors);
      return [
        connections,
        connectionsOfStrangers,
        connectionsPerNetwork,
        connectionsPerAddress,
      ] as const;
    };
    expect(fit(undefined)).toEqual([12_288, 2_048, 1_024, 512]);
    expect(fit(1_048_576)).toEqual([12_288, 2_048, 1_024, 512]);
    expect(fit(700)).toEqual([286, 143, 107, 71]);
    expect(fit(16)).toEqual([16, 8, 6, 4]);
  });
});
