import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { SessionState, type Session } from '@ubii/proto';
import type { GameId } from '../../sim/index.ts';
import { gameSession, PARTY_TAG } from './game-session.ts';

/** The sessions of the games on the master: one at a time, so that nothing runs that nobody plays. */
export class GameSessions {
  readonly #client: UbiiClient;
  readonly #handleTrouble: (sentence: string) => void;
  #open: { readonly game: GameId; readonly id: string } | undefined;
  /** One change after the other. */
  #turn: Promise<unknown> = Promise.resolve();

  constructor(client: UbiiClient, handleTrouble: (sentence: string) => void) {
    this.#client = client;
    this.#handleTrouble = handleTrouble;
  }

  idOf(game: GameId): string | undefined {
    return this.#open?.game === game ? this.#open.id : undefined;
  }

  /** Makes sure that the session of a game runs, and no other of the party. @returns whether it was started now */
  open(game: GameId): Promise<boolean> {
    return this.#inTurn(async () => {
      const all = await this.#list();
      const own = all.find((session) => session.tags.includes(game));
      for (const session of all) if (session !== own) await this.#remove(session.id);
      const runs = own !== undefined && isRunning(own);
      const session = runs
        ? own
        : await this.#client.call('sessionRuntimeStart', own ? { id: own.id } : gameSession(game));
      this.#open = { game, id: session.id };
      return !runs;
    }, false);
  }

  removeAll(): Promise<void> {
    return this.#inTurn(async () => {
      this.#open = undefined;
      for (const { id } of await this.#list()) await this.#remove(id);
    }, undefined);
  }

  #inTurn<T>(act: () => Promise<T>, otherwise: T): Promise<T> {
    const done = this.#turn.then(act).catch((cause: unknown) => {
      // The connection says by itself that it is lost
      if (!(cause instanceof ConnectionError))
        this.#handleTrouble(cause instanceof Error ? cause.message : String(cause));
      return otherwise;
    });
    this.#turn = done;
    return done;
  }

  async #list(): Promise<readonly Session[]> {
    const { elements } = await this.#client.call('sessionRuntimeGetList');
    return elements.filter(({ tags }) => tags.includes(PARTY_TAG));
  }

  async #remove(id: string): Promise<void> {
    await this.#client.call('sessionRuntimeRemove', { id });
  }
}

const RUNS: readonly SessionState[] = [
  SessionState.SESSION_STARTING,
  SessionState.SESSION_RUNNING,
  SessionState.SESSION_DEGRADED,
];

function isRunning({ extension }: Session): boolean {
  return RUNS.includes(extension?.state ?? SessionState.SESSION_CREATED);
}
