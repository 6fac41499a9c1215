import { isSameValue } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import type { AccessSecrets } from '../ports/access-secrets.ts';
import type { DocumentStore } from '../ports/document-store.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { Log } from '../ports/log.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { CREDENTIAL_LIFETIME_MS } from './credentials.ts';
import { grantFromJson, grantToJson, type Grant, type GrantId, type GrantSpec } from './grant.ts';
import { createJoinCode, readJoinCode } from './join-code.ts';

/** The end of credentials is kept in steps of this size, so that not every registration writes a file. */
const KEPT_STEP_MS = 24 * 3_600_000;

/** Dependencies of grants. */
export interface GrantsContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly secrets: AccessSecrets;
  readonly store: DocumentStore;
  readonly limits: LimitWatch;
  readonly log: Log;
  /** Other masters have the same grants, and change them. [CU-27] */
  readonly isShared: boolean;
  /** Tells installations apart that share grants. */
  readonly installation: string;
}

/** A grant with its secrets, which cannot be read again later [AC-11]. */
export interface NewGrant {
  readonly grant: Grant;
  readonly token: string;
  readonly code: string;
}

function areSame(a: Grant, b: Grant): boolean {
  return isSameValue({ ...grantToJson(a), isOver: false }, { ...grantToJson(b), isOver: false });
}

/** Every grant that is kept, found by id, token and code [AC-10] [AC-19]. */
export class Grants {
  /** Another master revoked a grant. [CU-27] */
  readonly onRevoked = new Hook<[grant: Grant]>();
  readonly #context: GrantsContext;
  readonly #grants = new Map<string, Grant>();
  readonly #byToken = new Map<string, Grant>();
  /** Grants that are being kept: whether they have changed since. */
  readonly #changed = new Map<Grant, boolean>();
  readonly #byCode = new Map<string, Grant>();

  constructor(context: GrantsContext) {
    this.#context = context;
    for (const [key, { json, fault }] of context.store.documents()) {
      const grant = grantFromJson(json);
      if (grant !== undefined) this.#index(grant);
      else {
        const reason = fault ?? 'the file does not contain an invitation';
        context.log.warn('an invitation cannot be read', {
          where: context.store.describe(key),
          reason,
        });
      }
    }
    if (context.isShared) context.store.onChange((keys) => keys.forEach((key) => this.#learn(key)));
  }

  /** Tells installations apart that share grants; empty for a master that is alone. */
  get installation(): string {
    return this.#context.installation;
  }

  get size(): number {
    return this.#grants.size;
  }

  /** The newest first. */
  list(): Grant[] {
    return [...this.#grants.values()].sort((a, b) => b.createdMs - a.createdMs);
  }

  get(id: string): Grant | undefined {
    return this.#grants.get(id);
  }

  findByToken(token: string): Grant | undefined {
    return this.#byToken.get(this.#context.secrets.fingerprint(`token ${token}`));
  }

  /** @param code as `readJoinCode` gives it */
  findByCode(code: string): Grant | undefined {
    return this.#byCode.get(this.#context.secrets.fingerprint(`code ${code}`));
  }

  /**
   * Makes a grant; it is kept when the promise is fulfilled [AC-19].
   *
   * @param staysUntilMs end of those who join, epoch milliseconds; its own end when that is later [AC-91]
   * @returns the grant with its secrets, which cannot be read again later [AC-11]
   * @throws ServiceError when there is no room
   */
  async create(spec: GrantSpec, staysUntilMs = spec.expiresMs): Promise<NewGrant> {
    const { clock, ids, limits } = this.#context;
    const max = limits.limits.grants;
    if (this.#grants.size >= max && !(await this.#makeRoom())) {
      throw limits.refusal('grants', `more than ${max} invitations`);
    }
    const { token, code, hashes } = this.#newSecrets();
    const grant: Grant = {
      ...spec,
      id: ids.uuid() as GrantId,
      createdMs: clock.nowMs(),
      ...hashes,
      revokedMs: 0,
      isHandedOver: false,
      joins: 0,
      credentialsEndMs: 0,
      closedMs: spec.expiresMs,
      staysUntilMs: Math.max(spec.expiresMs, staysUntilMs),
      isOver: false,
    };
    await this.#keep(grant);
    this.#index(grant);
    return { grant, token, code };
  }

  /**
   * Replaces the secrets and the end of a grant; clients that joined with it stay [AC-42].
   *
   * @param expiresMs end of token and code, epoch milliseconds
   */
  async renew(grant: Grant, expiresMs: number): Promise<NewGrant> {
    const { token, code, hashes } = this.#newSecrets();
    this.#unindex(grant);
    Object.assign(grant, hashes, {
      expiresMs,
      codeExpiresMs: expiresMs,
      closedMs: expiresMs,
      staysUntilMs: expiresMs,
    });
    this.#index(grant);
    await this.#keep(grant);
    return { grant, token, code };
  }

  /** Takes a grant back, permanently [AC-15]. It counts at once, and is kept when the promise is fulfilled. */
  async revoke(grant: Grant, isHandedOver: boolean): Promise<void> {
    grant.isHandedOver = isHandedOver;
    if (grant.revokedMs === 0) grant.revokedMs = this.#context.clock.nowMs();
    await this.#keep(grant);
  }

  /** Those whose time is over, and whose clients were not ended for it yet [AC-91]. They count as ended then. */
  takeOver(): Grant[] {
    const nowMs = this.#context.clock.nowMs();
    const over = this.list().filter(
      ({ staysUntilMs, isOver, revokedMs }) => !isOver && revokedMs === 0 && staysUntilMs <= nowMs,
    );
    for (const grant of over) {
      grant.isOver = true;
      this.#keep(grant).catch((error: unknown) =>
        this.#context.log.warn('an invitation could not be saved', { reason: String(error) }),
      );
    }
    return over;
  }

  /** Tells whether clients that joined with it still have access. */
  isValid(id: GrantId): boolean {
    const grant = this.#grants.get(id);
    return (
      grant !== undefined &&
      grant.revokedMs === 0 &&
      grant.staysUntilMs > this.#context.clock.nowMs()
    );
  }

  /**
   * Disables joining with the codes of earlier terminals, and removes those without a joined client
   * [AC-19].
   */
  async closeTerminals(): Promise<void> {
    const nowMs = this.#context.clock.nowMs();
    for (const grant of this.list()) {
      if (!this.isOwnTerminals(grant) || grant.hereOnly) continue;
      if (grant.joins === 0) await this.#forget(grant);
      else if (grant.closedMs > nowMs) {
        grant.closedMs = nowMs;
        await this.#keep(grant);
      }
    }
  }

  /** Whether a terminal of this installation shows it, or showed it. */
  isOwnTerminals({ isTerminal, terminalOf }: Grant): boolean {
    return isTerminal && terminalOf === this.#context.installation;
  }

  /** When a credential given now ends; undefined when the grant gives none any more [AC-13]. */
  credentialEndMs(grant: Grant): number | undefined {
    const nowMs = this.#context.clock.nowMs();
    const endMs = Math.min(nowMs + CREDENTIAL_LIFETIME_MS, grant.staysUntilMs);
    return endMs > nowMs ? endMs : undefined;
  }

  /**
   * Counts a credential; `hasJoined`: the client is new. A number of joins that
   * is limited is stored when the promise is fulfilled, so that a code is not used again after a crash [AC-18].
   */
  async count(grant: Grant, endMs: number, hasJoined: boolean): Promise<void> {
    if (hasJoined) grant.joins++;
    const isNew = endMs > grant.credentialsEndMs;
    if (isNew) grant.credentialsEndMs = Math.ceil(endMs / KEPT_STEP_MS) * KEPT_STEP_MS;
    if (!hasJoined && !isNew) return;
    if (hasJoined && grant.maxJoins > 0) await this.#keep(grant);
    else void this.#keepSoon(grant);
  }

  /** Keeps it as it is then, once for all that come meanwhile: many joins do not hold up a revocation. */
  async #keepSoon(grant: Grant): Promise<void> {
    const isUnderWay = this.#changed.has(grant);
    this.#changed.set(grant, true);
    if (isUnderWay) return;
    try {
      while (this.#changed.get(grant) === true && this.#grants.has(grant.id)) {
        this.#changed.set(grant, false);
        await this.#keep(grant);
      }
    } catch (error) {
      this.#context.log.warn('an invitation could not be saved', { reason: String(error) });
    } finally {
      this.#changed.delete(grant);
    }
  }

  #newSecrets() {
    const { secrets } = this.#context;
    const token = secrets.token();
    const code = createJoinCode(secrets);
    const hashes = {
      token: secrets.fingerprint(`token ${token}`),
      code: secrets.fingerprint(`code ${readJoinCode(code)!}`),
    };
    return { token, code, hashes };
  }

  #index(grant: Grant): void {
    this.#grants.set(grant.id, grant);
    this.#byToken.set(grant.token, grant);
    this.#byCode.set(grant.code, grant);
  }

  /** Another master made, changed or removed a grant. */
  #learn(key: string): void {
    const told = grantFromJson(this.#context.store.documents().get(key)?.json);
    const known = this.#grants.get(key);
    if (told === undefined || told.id !== key) {
      if (known === undefined) return;
      this.#unindex(known);
      known.revokedMs ||= this.#context.clock.nowMs();
      this.onRevoked.emit(known);
      return;
    }
    if (known === undefined) return this.#index(told);
    const wasGood = known.revokedMs === 0;
    const merged = this.#merge(known, told);
    this.#unindex(known);
    Object.assign(known, merged);
    this.#index(known);
    if (wasGood && known.revokedMs > 0) this.onRevoked.emit(known);
    // The other master wrote before it knew what this one had written.
    const isBehind = told.revokedMs === 0 || told.joins < known.joins;
    if (isBehind && !areSame(told, known)) void this.#keepSoon(known);
  }

  /** Nothing that ended a grant, or used it up, is taken back by who did not know of it. */
  #merge(known: Grant, told: Grant): Grant {
    const keepsSecrets = this.isOwnTerminals(known) && known.hereOnly;
    return {
      ...told,
      // Secrets change where the terminal is that shows them.
      ...(keepsSecrets && { token: known.token, code: known.code, expiresMs: known.expiresMs }),
      ...(keepsSecrets && { codeExpiresMs: known.codeExpiresMs, staysUntilMs: known.staysUntilMs }),
      closedMs: keepsSecrets ? known.closedMs : Math.min(known.closedMs, told.closedMs),
      revokedMs: known.revokedMs || told.revokedMs,
      isHandedOver: known.isHandedOver || told.isHandedOver,
      joins: Math.max(known.joins, told.joins),
      credentialsEndMs: Math.max(known.credentialsEndMs, told.credentialsEndMs),
      // Each master ends the clients that joined at it.
      isOver: known.isOver,
    };
  }

  #keep(grant: Grant): Promise<void> {
    return this.#context.store.write(grant.id, grantToJson(grant));
  }

  async #forget(grant: Grant): Promise<void> {
    this.#unindex(grant);
    await this.#context.store.delete(grant.id);
  }

  #unindex(grant: Grant): void {
    this.#grants.delete(grant.id);
    if (this.#byToken.get(grant.token) === grant) this.#byToken.delete(grant.token);
    if (this.#byCode.get(grant.code) === grant) this.#byCode.delete(grant.code);
  }

  /** Removes the oldest grant that no client uses any more [AC-10]. */
  async #makeRoom(): Promise<boolean> {
    const nowMs = this.#context.clock.nowMs();
    const idle = this.list().filter(
      ({ revokedMs, closedMs, credentialsEndMs }) =>
        revokedMs > 0 || (closedMs <= nowMs && credentialsEndMs <= nowMs),
    );
    const goes = idle.findLast(({ revokedMs }) => revokedMs > 0) ?? idle.at(-1);
    if (goes === undefined) return false;
    await this.#forget(goes);
    return true;
  }
}
