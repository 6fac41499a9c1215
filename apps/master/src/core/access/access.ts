import { JoinProblem, type ClientExtension, type ServiceError } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { AccessSecrets } from '../ports/access-secrets.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { ResumeTokens } from '../ports/resume-tokens.ts';
import { quote } from '../texts/quote.ts';
import type { Caller, ClientAccess } from './caller.ts';
import { looksLikeCredential, readCredential, writeCredential } from './credentials.ts';
import type { Grant } from './grant.ts';
import type { Grants } from './grants.ts';
import type { GuessLimit, GuessSource } from './guess-limit.ts';
import { readJoinCode } from './join-code.ts';
import { joinRefusal, roleRefusal } from './join-refusals.ts';
import { mayCall, type ServiceRight } from './rights-table.ts';

/** Dependencies of access decisions. */
export interface AccessContext {
  readonly clock: Clock;
  readonly secrets: AccessSecrets;
  readonly tokens: ResumeTokens;
  readonly grants: Grants;
  readonly guesses: GuessLimit;
  /** Returns the access of a registered client; undefined for unknown ids. */
  readonly accessOf: (clientId: string) => ClientAccess | undefined;
}

/** Where a caller is, and which master it called. */
type CallerPlace = Pick<CallerFacts, 'isHere' | 'calledMaster'>;

/** Meaning of a token, code or credential. */
type Found =
  | { readonly problem: JoinProblem; readonly grant?: undefined }
  | { readonly problem?: undefined; readonly grant: Grant };

const { JOIN_PROBLEM_EXPIRED, JOIN_PROBLEM_GUESSING, JOIN_PROBLEM_MISSING } = JoinProblem;
const { JOIN_PROBLEM_REVOKED, JOIN_PROBLEM_USED, JOIN_PROBLEM_WRONG } = JoinProblem;

const TRUSTED: Caller = { kind: 'local', role: 'admin' };
const LOCAL: Caller = { kind: 'local', role: 'participant' };
const NETWORK: Caller = { kind: 'network', role: 'participant' };

/** Decides which callers are admitted, and their rights. */
export class Access {
  readonly grants: Grants;
  readonly #context: AccessContext;
  /** Makes groups of addresses others in each run. */
  #salt: string | undefined;

  constructor(context: AccessContext) {
    this.#context = context;
    this.grants = context.grants;
  }

  /** Identifies a caller. An invalid token is not treated like a missing one. [AC-3] */
  identify(facts: CallerFacts): Caller {
    const { standing, bearer } = facts;
    if (bearer !== undefined) return this.#identifyBearer(bearer, facts);
    if (standing === 'trusted') return TRUSTED;
    if (standing === 'local') return LOCAL;
    if (standing === 'network') return NETWORK;
    return stranger(JOIN_PROBLEM_MISSING);
  }

  /** A text that callers of one address share, which does not tell the address [EX-99]. */
  addressGroup({ place }: CallerFacts): string {
    const { secrets } = this.#context;
    this.#salt ??= secrets.token();
    return secrets.fingerprint(`${this.#salt} ${place}`);
  }

  /**
   * @param actsFor id of the client for which the request is sent, if it names one
   * @throws ServiceError when this caller may not call the service, or not for that client
   */
  authorize(
    caller: Caller,
    service: ServiceRight,
    topic: string,
    actsFor: string | undefined,
  ): void {
    const { roles, actsForClient } = service;
    if (roles === 'anyone') return;
    if (caller.kind === 'stranger') throw caller.refusal;
    if (caller.kind === 'joining') throw joinRefusal(JOIN_PROBLEM_MISSING);
    const { role } = caller;
    if (!mayCall(service, role)) {
      throw roleRefusal(
        `The service ${topic} is for ${listed(roles)}; this device joined as ${role}.`,
      );
    }
    if (actsForClient && actsFor !== undefined && !this.mayActFor(caller, actsFor)) {
      throw roleRefusal(`The request was sent for the client ${quote(actsFor)}, but not by it.`);
    }
  }

  /** Whether this caller speaks for a client [AC-22]. */
  mayActFor(caller: Caller, clientId: string): boolean {
    switch (caller.kind) {
      case 'local':
        return caller.role === 'admin' || this.#isLikeUs(clientId, caller);
      case 'client':
        return clientId === caller.clientId;
      case 'network':
        return this.#isLikeUs(clientId, caller);
      case 'joining':
      case 'stranger':
        return false;
    }
  }

  /** Whether a resume token proves a client that came in from this machine without an invitation. [AC-27] */
  provesLocalClient(clientId: string, token: string): boolean {
    return this.#context.accessOf(clientId)?.kind === 'local' && this.#isProven(clientId, token);
  }

  /**
   * Whether a socket is opened for this client [AC-27].
   * @returns why not
   */
  refuseSocket(
    { standing }: CallerFacts,
    clientId: string,
    token: string,
  ): ServiceError | undefined {
    if (standing === 'trusted') return undefined;
    const access = this.#context.accessOf(clientId);
    const mayTry = access === undefined || access.kind === 'grant';
    if (standing === 'local' && isLike(access, LOCAL)) return undefined;
    if (standing === 'network' && isLike(access, NETWORK)) return undefined;
    // Only a client that proves its former id learns the reason.
    if (!mayTry || !this.#isProven(clientId, token)) return joinRefusal(JOIN_PROBLEM_MISSING);
    const isOver = access !== undefined && access.expiresMs <= this.#context.clock.nowMs();
    return isOver ? joinRefusal(JOIN_PROBLEM_EXPIRED) : undefined;
  }

  /** Describes a token or code for any caller [AC-16]. */
  check(secret: string, source: GuessSource & CallerPlace): Found {
    const code = readJoinCode(secret);
    if (code === undefined)
      return this.#usable(this.#here(this.grants.findByToken(secret), source));
    const { guesses } = this.#context;
    if (!guesses.mayTry(source)) return { problem: JOIN_PROBLEM_GUESSING };
    const grant = this.#here(this.grants.findByCode(code), source);
    if (grant === undefined) guesses.countWrong(source);
    return this.#usable(grant, grant?.codeExpiresMs);
  }

  /** When a credential given now ends [AC-13]. @throws ServiceError when the grant gives none any more */
  credentialEndMs(grant: Grant): number {
    const endMs = this.grants.credentialEndMs(grant);
    if (endMs === undefined) throw joinRefusal(JOIN_PROBLEM_EXPIRED);
    return endMs;
  }

  /** The credential of a client, as its registration says it; nothing for one that needs none. */
  credentialOf(
    clientId: string,
    { grant, holderId, expiresMs }: ClientAccess,
  ): Pick<ClientExtension, 'credential' | 'credentialExpiresMs'> | undefined {
    if (grant === undefined) return undefined;
    const { secrets } = this.#context;
    const credential = writeCredential(secrets, {
      clientId,
      grantId: grant.id,
      holderId: holderId ?? clientId,
      expiresMs,
    });
    return { credential, credentialExpiresMs: expiresMs };
  }

  #isProven(clientId: string, token: string): boolean {
    return clientId !== '' && token !== '' && this.#context.tokens.verify(clientId, token);
  }

  #identifyBearer(bearer: string, facts: CallerFacts): Caller {
    if (!looksLikeCredential(bearer)) {
      const { grant, problem } = this.check(bearer, facts);
      return grant === undefined ? stranger(problem) : { kind: 'joining', role: 'none', grant };
    }
    const credential = readCredential(this.#context.secrets, bearer);
    if (credential === undefined) return stranger(JOIN_PROBLEM_WRONG);
    const grant = this.grants.get(credential.grantId);
    const { clientId, holderId, expiresMs } = credential;
    if (grant !== undefined && this.#here(grant, facts) === undefined) {
      return stranger(JOIN_PROBLEM_WRONG);
    }
    if (grant === undefined || grant.revokedMs > 0) return stranger(JOIN_PROBLEM_REVOKED);
    const endMs = Math.min(expiresMs, grant.staysUntilMs);
    if (endMs <= this.#context.clock.nowMs()) return stranger(JOIN_PROBLEM_EXPIRED);
    return { kind: 'client', role: grant.role, clientId, grant, holderId, expiresMs };
  }

  /** The grant where it may be used: that of a terminal is as good as none elsewhere, also at another master [AC-43]. */
  #here(grant: Grant | undefined, { isHere, calledMaster }: CallerPlace): Grant | undefined {
    if (grant?.hereOnly !== true) return grant;
    const installation = calledMaster?.installation ?? this.grants.installation;
    return isHere && grant.terminalOf === installation ? grant : undefined;
  }

  /** Whether a client came in like this caller, without a token; one that is not there may have. */
  #isLikeUs(clientId: string, caller: Caller): boolean {
    return isLike(this.#context.accessOf(clientId), caller);
  }

  #usable(grant: Grant | undefined, codeExpiresMs = Number.POSITIVE_INFINITY): Found {
    if (grant === undefined) return { problem: JOIN_PROBLEM_WRONG };
    if (grant.revokedMs > 0) return { problem: JOIN_PROBLEM_REVOKED };
    const nowMs = this.#context.clock.nowMs();
    if (Math.min(grant.closedMs, codeExpiresMs) <= nowMs) return { problem: JOIN_PROBLEM_EXPIRED };
    return { grant };
  }
}

function isLike(access: ClientAccess | undefined, { kind, role }: Caller): boolean {
  return access === undefined || (access.kind === kind && access.role === role);
}

/** True when another client may join with the grant [AC-18]. */
export function isUsedUp({ maxJoins, joins }: Grant): boolean {
  return maxJoins > 0 && joins >= maxJoins;
}

/** Everybody has joined with it that may. */
export function usedRefusal(): ServiceError {
  return joinRefusal(JOIN_PROBLEM_USED);
}

function stranger(problem: JoinProblem): Caller {
  return { kind: 'stranger', role: 'none', refusal: joinRefusal(problem) };
}

/** `admins`, `admins and participants` */
function listed(roles: readonly string[]): string {
  return roles
    .map((role) => `${role}s`)
    .join(', ')
    .replace(/, ([^,]*)$/, ' and $1');
}
