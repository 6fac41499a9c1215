import { createMemoryIdentity, type UbiiClient } from '@ubii/client-web';
import { createClient } from '@ubii/client-web/node';
import type { MasterProcess } from '@ubii/harness';
import { SERVICES, type Client } from '@ubii/proto';
import { afterEach, beforeEach, expect, inject } from 'vitest';
import { CLIENT_NAMES, type ClientKind } from './client-kind.ts';
import { LegacyClient, type LegacyAddresses } from './legacy-client.ts';
import { endMaster, startMaster } from '../../fixtures/start-master.ts';

/** A master with both old ports, and the clients that joined it. */
export interface Room {
  readonly master: MasterProcess;
  /** Addresses for existing clients: the legacy ports on loopback. */
  readonly legacy: LegacyAddresses;
  /** The same for those that use ZeroMQ. */
  readonly zeromq: LegacyAddresses;
  /** A published client, connected over the old ports. */
  joins(kind: ClientKind, name?: string): Promise<Guest>;
  /** A published client that runs processing modules, connected over the old ports. */
  joinsAsNode(kind: 'nodejs' | 'python', name?: string): Promise<Guest>;
  /** The published nodejs node, connected over the ports of ZeroMQ. */
  joinsOverZeroMq(name?: string): Promise<Guest>;
  /** A client of ours, connected. */
  oursJoins(name?: string): Promise<UbiiClient>;
  /** A client as the master lists it, asked for by a client of ours. */
  listed(asker: UbiiClient, clientId: string): Promise<Client | undefined>;
}

/** A published client in the room. */
export type Guest = LegacyClient & { readonly clientId: string };

/** Gives every test of the file a master of its own, and ends all that joined it. */
export function useRoom(): Room {
  let master: MasterProcess | undefined;
  let legacy: OldAddresses | undefined;
  let leave: (() => Promise<void>)[] = [];
  const join = async (
    kind: ClientKind,
    name = `${kind} guest`,
    options: { readonly modules?: boolean } = {},
    addresses = room.legacy,
  ): Promise<Guest> => {
    const client = await LegacyClient.start(kind);
    leave.push(() => client.stop());
    const { clientId } = await client.connect(addresses, name, options);
    return Object.assign(client, { clientId });
  };
  const room: Room = {
    get master() {
      if (!master) throw new Error('The room is open only while a test runs.');
      return master;
    },
    get legacy() {
      if (!legacy) throw new Error('The room is open only while a test runs.');
      return legacy.http;
    },
    get zeromq() {
      if (!legacy) throw new Error('The room is open only while a test runs.');
      return legacy.zeromq;
    },
    joins: (kind, name) => join(kind, name),
    joinsOverZeroMq: (name) => join('nodejs', name, {}, room.zeromq),
    joinsAsNode: (kind, name) => join(kind, name, { modules: true }),
    async oursJoins(name = 'our guest') {
      const client = createClient({ url: room.master.url, name, identity: createMemoryIdentity() });
      leave.push(() => client.close());
      await client.connect();
      return client;
    },
    async listed(asker, clientId) {
      const list = await asker.call('clientGetList', { elements: [{ id: clientId }] });
      return list.elements[0];
    },
  };

  beforeEach(async () => {
    leave = [];
    master = await startMaster({
      trustsLoopback: false,
      flags: ['--legacy-ports', '0,0', '--zeromq-ports', '0,0'],
    });
    legacy = await whereClientsLook(master);
  });
  afterEach(async () => {
    await Promise.all(leave.map((each) => each()));
    const { failures } = room.master;
    await endMaster(room.master);
    expect(failures, 'lines in the log of the master that say something broke').toEqual([]);
  });
  return room;
}

/** Name of a test suite about one client; says so when it cannot run here. */
export function suiteName(kind: ClientKind): string {
  const missing = whyMissing(kind);
  return missing ? `${CLIENT_NAMES[kind]} (skipped: ${missing})` : CLIENT_NAMES[kind];
}

/** Why a client cannot run here, or `undefined`. */
export function whyMissing(kind: ClientKind): string | undefined {
  const installation = inject('installations')[kind];
  return 'missing' in installation ? installation.missing : undefined;
}

/** Addresses for both ways of existing clients. */
interface OldAddresses {
  readonly http: LegacyAddresses;
  readonly zeromq: LegacyAddresses;
}

/** The ports the master tells existing clients. */
export async function whereClientsLook(master: MasterProcess): Promise<OldAddresses> {
  const response = await fetch(master.endpoints.servicesJson, {
    method: 'POST',
    headers: { 'content-type': 'application/json' },
    body: JSON.stringify({ topic: SERVICES.serverConfiguration.topic }),
  });
  const { server } = (await response.json()) as { server: Record<string, string> };
  return {
    http: {
      services: `http://localhost:${server['portServiceRest']}/services/json`,
      topicData: `ws://localhost:${server['portTopicDataWs']}`,
    },
    zeromq: {
      services: `tcp://localhost:${server['portServiceZmq']}`,
      topicData: `tcp://localhost:${server['portTopicDataZmq']}`,
    },
  };
}
