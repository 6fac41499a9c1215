import { isIPv4 } from 'node:net';
import { endianness } from 'node:os';
import { setImmediate as nextTurn, setTimeout as sleep } from 'node:timers/promises';

import { systemTables, type ReadSocketTable, type SocketTable } from './socket-tables.ts';

/** The two ends of a connection, as a server sees it. */
export interface PeerSocket {
  readonly remoteAddress?: string | undefined;
  readonly remotePort?: number | undefined;
  readonly localAddress?: string | undefined;
  readonly localPort?: number | undefined;
  readonly destroyed?: boolean;
}

/** Operating system queries of `PeerOwners`. */
export interface OwnerSource {
  /** Reads a table as Linux writes it; undefined where there are none. */
  readonly readTable: ReadSocketTable | undefined;
  /** The user that the master runs as; undefined where there are no numbers for users. */
  readonly userId: number | undefined;
}

/** A socket whose owner is looked for. */
interface Question {
  readonly socket: PeerSocket;
  /** How the tables write its peer. */
  readonly ends: Readonly<Partial<Record<SocketTable, string>>>;
  readonly answered: () => void;
  owner: number | undefined;
}

/** Widths of `<local address>:<port> <remote address>:<port>`, characters. */
const ENDS_WIDTH: Readonly<Record<SocketTable, number>> = { tcp: 27, tcp6: 75 };
/** SYN_SENT: this connection was not accepted yet, so it is none of those that are asked about. */
const CONNECTING = '02';
/** Time for which sockets are waited for that share the next read, in times of the last one: reads take a third of the time. */
const GATHERING_SHARE = 2;
/** Longest wait, milliseconds: a table takes longer on a busy machine. */
const MAX_GATHERING_MS = 10;

/**
 * Finds the user of the program that opened a local connection: the operator's user, or another one
 * (a proxy, another person), who is a stranger. Available on Linux only. [AC-1]
 *
 * The system walks through all its sockets for one question, which takes milliseconds. Sockets that are
 * asked about while a table is read, or a moment later, share the next one; none is judged by a table that
 * was opened before it was asked about, because its port may have been another program's then.
 */
export class PeerOwners {
  readonly #source: OwnerSource;
  /** A socket stays with the one who made it. */
  readonly #known = new WeakMap<PeerSocket, boolean>();
  readonly #pending = new Map<PeerSocket, Promise<void>>();
  #waiting: Question[] = [];
  #isReading = false;
  /** How long the last read took, milliseconds. */
  #readMs = 0;

  constructor(source: OwnerSource = linux()) {
    this.#source = source;
  }

  /** Whether the system tells it here. */
  get canTell(): boolean {
    return this.#source.userId !== undefined && this.#source.readTable !== undefined;
  }

  /**
   * Looks for the owner of the other end.
   *
   * @param socket a connection from this machine
   * @returns undefined when it is known, or cannot be told; the promise is never rejected
   */
  learn(socket: PeerSocket): Promise<void> | undefined {
    if (!this.canTell || this.#known.has(socket)) return undefined;
    const pending = this.#pending.get(socket);
    if (pending !== undefined) return pending;
    const learnt = new Promise<void>((resolve) => {
      const answered = (): void => {
        this.#pending.delete(socket);
        resolve();
      };
      this.#waiting.push({ socket, ends: endsOf(socket), answered, owner: undefined });
    });
    this.#pending.set(socket, learnt);
    if (!this.#isReading) void this.#answerAll();
    return learnt;
  }

  /**
   * Whether the other end is a socket of the operator's user, where that can be told; else true.
   *
   * @param socket a connection from this machine; one that nothing was learnt of is a stranger's
   */
  isOperators(socket: PeerSocket): boolean {
    return !this.canTell || this.#known.get(socket) === true;
  }

  async #answerAll(): Promise<void> {
    this.#isReading = true;
    while (this.#waiting.length > 0) {
      await this.#gather();
      const questions = this.#waiting;
      this.#waiting = [];
      const startMs = performance.now();
      await this.#findOwners(questions);
      this.#readMs = performance.now() - startMs;
      // A port changes hands only after its connection was reset. A turn later that has been seen,
      // and what the table says of the port is not said of the connection before.
      await nextTurn();
      for (const { socket, owner, answered } of questions) {
        const isOurs = owner !== undefined && owner === this.#source.userId;
        this.#known.set(socket, isOurs && socket.destroyed !== true);
        answered();
      }
    }
    this.#isReading = false;
  }

  /** Lets others come that share the read: those of this turn, and of the next milliseconds where a read takes long. */
  async #gather(): Promise<void> {
    const gatheringMs = Math.floor(Math.min(MAX_GATHERING_MS, GATHERING_SHARE * this.#readMs));
    await (gatheringMs < 1 ? nextTurn() : sleep(gatheringMs));
  }

  async #findOwners(questions: readonly Question[]): Promise<void> {
    for (const table of ['tcp', 'tcp6'] as const) {
      const open = new Map<string, Question>();
      for (const question of questions) {
        const ends = question.ends[table];
        if (ends !== undefined && question.owner === undefined) open.set(ends, question);
      }
      if (open.size === 0) continue;
      try {
        await this.#source.readTable!(table, (lines) => {
          findOwners(open, lines, ENDS_WIDTH[table]);
          return open.size > 0;
        });
      } catch {
        // Nothing was found: strangers.
      }
    }
  }
}

/** Fills in the owners of those that the lines have, and removes them from `open`. */
function findOwners(open: Map<string, Question>, lines: string, width: number): void {
  for (let start = 0; start < lines.length && open.size > 0;) {
    const endsAt = lines.indexOf(': ', start) + 2;
    if (endsAt < 2) return;
    const nextLine = lines.indexOf('\n', endsAt);
    const lineEnd = nextLine < 0 ? lines.length : nextLine;
    const ends = lines.slice(endsAt, endsAt + width);
    const question = open.get(ends);
    if (question !== undefined) {
      // Behind the ends: state, queues, timer, retransmits, user, timeout, inode.
      const rest = lines.slice(endsAt + width, lineEnd);
      const [state, , , , user, , inode] = rest.trim().split(/\s+/);
      // A socket without an inode has no owner any more, but the system reports user 0.
      if (inode !== undefined && inode !== '0' && state !== CONNECTING) {
        question.owner = Number(user);
        open.delete(ends);
      }
    }
    start = lineEnd + 1;
  }
}

/** The socket of the other end has ours the other way round. */
function endsOf(socket: PeerSocket): Question['ends'] {
  const { remoteAddress, remotePort = 0, localAddress, localPort = 0 } = socket;
  if (remoteAddress === undefined || localAddress === undefined) return {};
  const [remote, local] = [hexOf(remoteAddress), hexOf(localAddress)];
  const write = (prefix: string): string =>
    `${prefix}${remote}:${portText(remotePort)} ${prefix}${local}:${portText(localPort)}`;
  // IPv4 is in one table or, mapped, in the other.
  const isPlain = remote.length === WORD_DIGITS;
  return isPlain ? { tcp: write(''), tcp6: write(MAPPED) } : { tcp6: write('') };
}

const WORD_DIGITS = 8;
const MAPPED = `${wordText([0, 0, 0, 0]).repeat(2)}${wordText([0, 0, 255, 255])}`;

/** An address as the tables write it: 32 bits at a time, in the order of the machine's bytes. */
function hexOf(address: string): string {
  const plain = address.replace(/^::ffff:(?=\d+\.)/i, '').replace(/%.*$/, '');
  if (isIPv4(plain)) return wordText(plain.split('.').map(Number));
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
  return [0, 4, 8, 12].map((at) => wordText(bytes.slice(at, at + 4))).join('');
}

function wordText(bytes: readonly number[]): string {
  const ordered = endianness() === 'LE' ? [...bytes].reverse() : bytes;
  return ordered.map((byte) => byte.toString(16).padStart(2, '0').toUpperCase()).join('');
}

function portText(port: number): string {
  return port.toString(16).padStart(4, '0').toUpperCase();
}

function linux(): OwnerSource {
  const readTable = systemTables();
  return { userId: readTable && process.getuid?.(), readTable };
}
