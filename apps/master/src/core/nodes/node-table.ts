import {
  NodeExtensionKind,
  type NodeExtension,
  type NodeInfo,
  type ProcessingModule,
} from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import { offerOf, type Node } from './node.ts';

/** The master as a node, for the table. */
export interface MasterNode {
  readonly id: string;
  readonly name: string;
  readonly extension: NodeExtension;
  modules(): readonly ProcessingModule[];
}

/** Everything that can run modules: the master, and clients [PM-61]. */
export class NodeTable {
  readonly #master: MasterNode;
  readonly #clients: ClientRegistry;

  constructor(master: MasterNode, clients: ClientRegistry) {
    this.#master = master;
    this.#clients = clients;
  }

  get masterId(): string {
    return this.#master.id;
  }

  /** The master first, then by name. */
  list(): Node[] {
    const clients = [...this.#clients.values()].filter(isNode);
    return [this.#masterNode(), ...clients.map(nodeOf).sort(byLabel)];
  }

  /** A node, or a client that may be one: the original's clients run modules without saying so. */
  get(id: string): Node | undefined {
    if (id === this.#master.id) return this.#masterNode();
    const client = this.#clients.get(id);
    return client === undefined ? undefined : nodeOf(client);
  }

  /** The module of this name as a client offers it; of any client without an id. */
  offered(name: string, nodeId: string | undefined): ProcessingModule | undefined {
    if (nodeId === this.#master.id) return undefined;
    if (nodeId !== undefined) {
      const client = this.#clients.get(nodeId);
      return client?.spec.processingModules.find((module) => module.name === name);
    }
    for (const { status, spec } of this.#clients.values()) {
      if (status === 'unavailable') continue;
      const module = spec.processingModules.find((one) => one.name === name);
      if (module !== undefined) return module;
    }
    return undefined;
  }

  /** Whether a client that is not the master has a module of this name. */
  isOffered(name: string): boolean {
    return this.list().some((node) => offerOf(node, name) !== undefined);
  }

  /**
   * @param loadOf Modules of sessions a node runs now.
   * @param memoryOf Their memory, bytes.
   */
  toMessages(loadOf: (node: Node) => number, memoryOf: (node: Node) => number): NodeInfo[] {
    return this.list().map((node) => ({
      clientId: node.id,
      name: node.label,
      node: node.extension,
      moduleNames: node.modules.map(({ name }) => name),
      instances: loadOf(node),
      available: node.isAvailable,
      dedicated: node.isDedicated,
      memoryBytes: memoryOf(node),
    }));
  }

  #masterNode(): Node {
    const { id, name, extension } = this.#master;
    return {
      id,
      label: name,
      extension,
      isDedicated: true,
      isAvailable: true,
      modules: this.#master.modules(),
    };
  }
}

/** Returns the description of the master as a node. */
export function masterExtension(
  libraries: readonly string[],
  capacity: number,
  memoryBytes: number,
  loadsAssets: boolean,
): NodeExtension {
  return {
    kind: NodeExtensionKind.MASTER,
    runsJavascript: true,
    acceptsWork: true,
    libraries: [...libraries],
    capacity,
    memoryBytes,
    loadsAssets,
    records: false,
    isBridge: false,
  };
}

function isNode({ node, spec }: Client): boolean {
  // A bridge receives and replies like a node, and runs no modules. [BR-40]
  if (node?.isBridge === true) return false;
  return node !== undefined || spec.isDedicatedProcessingNode || spec.processingModules.length > 0;
}

function nodeOf(client: Client): Node {
  return {
    id: client.id,
    label: client.label,
    extension: client.node,
    isDedicated: client.spec.isDedicatedProcessingNode,
    isAvailable: client.status === 'active',
    modules: client.spec.processingModules,
  };
}

function byLabel(a: Node, b: Node): number {
  return a.label < b.label ? -1 : a.label > b.label ? 1 : 0;
}
