import {
  ClientState,
  type Client as ClientMessage,
  type ClusterClient,
  type Init,
} from '@ubii/proto';
import { givenRole, wireRole } from '../access/roles.ts';
import type { ClientAccess } from '../access/caller.ts';
import type { Grant } from '../access/grant.ts';
import { specOf, type Client, type ClientHome } from '../clients/client.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { ClientStatus } from '../clients/client-states.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { Log } from '../ports/log.ts';

const ACCESS_KINDS: readonly ClientAccess['kind'][] = ['local', 'network', 'grant'];

/** Dependencies of a directory. */
export interface DirectoryContext {
  readonly log: Log;
  readonly clients: ClientRegistry;
  readonly devices: DeviceRegistry;
  readonly grants: { get(id: string): Grant | undefined };
}

/** The clients of all masters in the list of this one. [CU-20] */
export class Directory {
  readonly #context: DirectoryContext;
  readonly #homes = new Map<string, ClientHome>();

  constructor(context: DirectoryContext) {
    this.#context = context;
  }

  /** Clients of this master. */
  own(): Client[] {
    return [...this.#context.clients.values()].filter(({ home }) => home === undefined);
  }

  /** Ids of the clients of another master. */
  idsOf(masterId: string): string[] {
    const ids: string[] = [];
    for (const { id, home } of this.#context.clients.values()) {
      if (home?.masterId === masterId) ids.push(id);
    }
    return ids;
  }

  /** A client of another master is there, or changed. */
  set(masterId: string, announced: ClusterClient): void {
    const { client: message } = announced;
    if (message === undefined || message.id === '') return;
    const { clients } = this.#context;
    const home = this.#homeOf(masterId);
    const known = clients.get(message.id);
    if (known !== undefined && !this.#isReachable(known, home, announced)) return; // [CU-22]
    const client = known ?? clients.addForeign(message.id, foreignParts(home, announced, message));
    client.hereSinceMs = announced.hereSinceMs;
    client.library = announced.library;
    client.node = announced.node;
    // Its own master judged its devices.
    client.publishRights = undefined;
    this.#setDevices(client, message);
    clients.admitForeign(client, this.#accessOf(announced));
    clients.setForeign(client, {
      spec: specOf(message),
      status: statusOf(message.state),
      mark: message.extension?.mark,
    });
  }

  /** The client left that master. */
  delete(masterId: string, id: string): void {
    const { clients } = this.#context;
    const client = clients.get(id);
    if (client?.home?.masterId === masterId) clients.handleEvent(client, 'deregistered');
  }

  /** Lists the clients of a silent master as away, until they come to another master. [CU-21] */
  handleLost(masterId: string): void {
    const home = this.#homes.get(masterId);
    if (home === undefined) return;
    this.#homes.delete(masterId);
    home.isLost = true;
    const { clients } = this.#context;
    for (const id of this.idsOf(masterId)) clients.handleHomeLost(clients.get(id)!);
  }

  /** Whether the client is at this master now, or else at another one that it came to later. */
  #isReachable(known: Client, home: ClientHome, { hereSinceMs }: ClusterClient): boolean {
    if (known.home?.masterId === home.masterId) {
      known.home = home;
      return true;
    }
    const isLater =
      known.home?.isLost === true ||
      hereSinceMs > known.hereSinceMs ||
      // Both masters decide the same.
      (hereSinceMs === known.hereSinceMs && known.home === undefined && !known.socket);
    if (!isLater) return false;
    if (known.home === undefined) this.#context.clients.giveAway(known, home);
    else known.home = home;
    return true;
  }

  #setDevices(client: Client, { devices }: ClientMessage): void {
    const registry = this.#context.devices;
    const ids = new Set(devices.map(({ id }) => id));
    for (const id of [...client.devices.keys()]) {
      if (!ids.has(id)) registry.deregister(client, id);
    }
    for (const device of devices) {
      try {
        registry.register(client, device);
      } catch (error) {
        const reason = error instanceof Error ? error.message : String(error);
        this.#context.log.warn('a device of another master was refused', { reason });
      }
    }
  }

  #accessOf({ role, grantId, accessKind }: ClusterClient): ClientAccess {
    const grant = this.#context.grants.get(grantId);
    const kind = ACCESS_KINDS.find((one) => one === accessKind) ?? 'grant';
    const expiresMs = Number.POSITIVE_INFINITY;
    // Its own master knows the holder, and so does the credential that it would bring here.
    return { kind, role: givenRole(role) ?? 'none', grant, holderId: undefined, expiresMs };
  }

  #homeOf(masterId: string): ClientHome {
    let home = this.#homes.get(masterId);
    if (home === undefined) {
      home = { masterId, isLost: false };
      this.#homes.set(masterId, home);
    }
    return home;
  }
}

/** Describes a client of this master for other masters. */
export function describeClient(client: Client): Init<ClusterClient> {
  const { access, isExtension, node, library, hereSinceMs, mark } = client;
  return {
    client: { ...client.toMessage(), extension: { mark } }, // [EX-100]
    isExtension,
    node,
    library,
    role: wireRole(access.role),
    grantId: access.grant?.id ?? '',
    hereSinceMs,
    accessKind: access.kind,
  };
}

function foreignParts(home: ClientHome, announced: ClusterClient, message: ClientMessage) {
  const { isExtension, hereSinceMs } = announced;
  return { home, spec: specOf(message), isExtension, hereSinceMs };
}

function statusOf(state: ClientState): ClientStatus {
  if (state === ClientState.ACTIVE) return 'active';
  return state === ClientState.INACTIVE ? 'inactive' : 'unavailable';
}
