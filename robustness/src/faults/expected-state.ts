import {
  AccessRole,
  SessionState,
  type Init,
  type ServiceReply,
  type ServiceRequest,
} from '@ubii/proto';

/** Asks the master; an error is a reply as well. @throws Error when there is no reply */
export type Ask = (request: Init<ServiceRequest>) => Promise<ServiceReply>;

/** Sessions are stored by name; their ids are those of a run. [SE-21] */
interface ExpectedSession {
  readonly name: string;
  /** Accepted contents: one text when the last change was acknowledged, else both. */
  texts: readonly string[];
  /** Whether it may be there: undefined when its deletion was not acknowledged. */
  isStored: boolean | undefined;
}

interface ExpectedGrant {
  readonly id: string;
  readonly token: string;
  /** undefined when its end was not acknowledged. */
  isValid: boolean | undefined;
}

/** Changes that a master acknowledged and must not lose. Those without acknowledgement may be stored or not. */
export class ExpectedState {
  readonly sessions = new Map<string, ExpectedSession>();
  readonly grants = new Map<string, ExpectedGrant>();
  /** Ids of sessions that were started to start with the master. */
  readonly running = new Set<string>();

  get size(): number {
    return this.sessions.size + this.grants.size + this.running.size;
  }

  /** Compares with what the master has. @returns what was lost, in words */
  async findLosses(ask: Ask): Promise<readonly string[]> {
    return [
      ...(await this.#lostSessions(ask)),
      ...(await this.#lostGrants(ask)),
      ...(await this.#lostRuns(ask)),
    ];
  }

  async #lostSessions(ask: Ask): Promise<string[]> {
    const reply = await ask({ topic: '/services/session/database/get_list' });
    if (reply.sessionList === undefined) return [`no list of sessions: ${reply.error?.message}`];
    const found = new Map(reply.sessionList.elements.map((session) => [session.name, session]));
    const lost: string[] = [];
    for (const { name, texts, isStored } of this.sessions.values()) {
      const session = found.get(name);
      if (session === undefined) {
        if (isStored === true) lost.push(`session "${name}" was stored, and is gone`);
      } else if (isStored === false) lost.push(`session "${name}" was deleted, and is there`);
      else if (!texts.includes(session.description)) {
        lost.push(`session "${name}" says "${session.description.slice(0, 40)}"`);
      }
    }
    return lost;
  }

  async #lostGrants(ask: Ask): Promise<string[]> {
    const lost: string[] = [];
    for (const { token, isValid } of this.grants.values()) {
      const { joinCheck, error } = await ask({
        topic: '/services/ubii/join_check',
        joinCheckRequest: { token },
      });
      const works = joinCheck?.role === AccessRole.ACCESS_ROLE_PLAYER;
      if (isValid === true && !works) {
        lost.push(`a token is good no more: ${joinCheck?.message ?? error?.message}`);
      }
      if (isValid === false && works) lost.push('a token was revoked, and is good');
    }
    return lost;
  }

  async #lostRuns(ask: Ask): Promise<string[]> {
    const lost: string[] = [];
    for (const id of this.running) {
      const { session, error } = await ask({
        topic: '/services/session/runtime/get',
        session: { id },
      });
      const state = session?.extension?.state;
      if (state !== SessionState.SESSION_RUNNING && state !== SessionState.SESSION_STARTING) {
        lost.push(`a session that starts with the master does not run: ${error?.message ?? state}`);
      }
    }
    return lost;
  }
}
