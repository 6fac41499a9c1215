import { readFileSync } from 'node:fs';
import { endianness } from 'node:os';
import { isIPv4 } from 'node:net';

/** The two ends of a connection, as a server sees it. */
export interface PeerSocket {
  readonly remoteAddress?: string | undefined;
  readonly remotePort?: number | undefined;
  readonly localAddress?: string | undefined;
  readonly localPort?: number | undefined;
}

/** Operating system queries of `PeerOwners`. */
export interface OwnerSource {
  /** The tables of TCP sockets as Linux writes them; undefined where there are none. */
  readonly tables: () => readonly string[] | undefined;
  /** The user that the master runs as; undefined where there are no numbers for users. */
  readonly userId: number | undefined;
}

/**
 * Finds the user of the program that opened a local connection: the operator's user, or another one
 * (a proxy, another person), who is a stranger. Available on Linux only. [AC-1]
 */
export class PeerOwners {
  readonly #source: OwnerSource;
  /** A socket stays with the one who made it. */
  readonly #known = new WeakMap<PeerSocket, boolean>();

  constructor(source: OwnerSource = linux()) {
    this.#source = source;
  }

  /** Whether the system tells it here. */
  get canTell(): boolean {
    return this.#source.userId !== undefined && this.#source.tables() !== undefined;
  }

  /**
   * Whether the other end is a socket of the operator's user, where that can be told; else true.
   *
   * @param socket a connection from this machine
   */
  isOperators(socket: PeerSocket): boolean {
    const known = this.#known.get(socket);
    if (known !== undefined) return known;
    const { userId, tables } = this.#source;
    const lines = userId === undefined ? undefined : tables();
    const isOurs = lines === undefined || ownerOf(socket, lines) === userId;
    this.#known.set(socket, isOurs);
    return isOurs;
  }
}

/** Returns the user of the other end; undefined when no process has it open any more. */
function ownerOf(socket: PeerSocket, tables: readonly string[]): number | undefined {
  const { remoteAddress, remotePort = 0, localAddress, localPort = 0 } = socket;
  if (remoteAddress === undefined || localAddress === undefined) return undefined;
  // Their end is ours the other way round, IPv4 in one table or, mapped, in the other.
  const ends = spellings(remoteAddress).flatMap((remote) =>
    spellings(localAddress).map(
      (local) => ` ${remote}:${portText(remotePort)} ${local}:${portText(localPort)} `,
    ),
  );
  for (const table of tables) {
    for (const end of ends) {
      const at = table.indexOf(end);
      if (at < 0) continue;
      // Behind the ends: state, queues, timer, retransmits, user, timeout, inode.
      const [, , , , user, , inode] = table
        .slice(at + end.length, table.indexOf('\n', at))
        .trim()
        .split(/\s+/);
      // A socket without an inode has no owner any more, but the system reports user 0.
      if (inode !== undefined && inode !== '0') return Number(user);
    }
  }
  return undefined;
}

/** An address as the tables write it: 32 bits at a time, in the order of the machine's bytes. */
function spellings(address: string): readonly string[] {
  const plain = address.replace(/^::ffff:(?=\d+\.)/i, '').replace(/%.*$/, '');
  if (isIPv4(plain)) {
    const word = wordText(plain.split('.').map(Number));
    return [word, `${wordText([0, 0, 0, 0]).repeat(2)}${wordText([0, 0, 255, 255])}${word}`];
  }
  const [head = '', tail] = plain.split('::');
  const groupsOf = (text: string): number[] =>
    text === '' ? [] : text.split(':').map((group) => Number.parseInt(group, 16));
  const before = groupsOf(head);
  const after = tail === undefined ? [] : groupsOf(tail);
  const missing = Math.max(0, 8 - before.length - after.length);
  const bytes = [...before, ...Array<number>(missing).fill(0), ...after].flatMap((group) => [
    group >> 8,
    group & 0xff,
  ]);
  return [[0, 4, 8, 12].map((at) => wordText(bytes.slice(at, at + 4))).join('')];
}

function wordText(bytes: readonly number[]): string {
  const ordered = endianness() === 'LE' ? [...bytes].reverse() : bytes;
  return ordered.map((byte) => byte.toString(16).padStart(2, '0').toUpperCase()).join('');
}

function portText(port: number): string {
  return port.toString(16).padStart(4, '0').toUpperCase();
}

function linux(): OwnerSource {
  return {
    userId: process.platform === 'linux' ? process.getuid?.() : undefined,
    tables: () => {
      const tables = ['/proc/net/tcp', '/proc/net/tcp6'].flatMap((file) => {
        try {
          return [readFileSync(file, 'latin1')];
        } catch {
          return [];
        }
      });
      return tables.length === 0 ? undefined : tables;
    },
  };
}
