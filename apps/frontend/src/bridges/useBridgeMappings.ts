import { ConnectionError } from '@ubii/client-web';
import {
  BridgeOutcome,
  ServiceError,
  type BridgeMappingProblem,
  type BridgeMappings,
  type BridgeMatch,
} from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import * as v from 'valibot';
import { useConnection } from '../connection/useConnection.ts';
import { readStored } from '../json/read-stored.ts';
import { applyChange, type MappingChange, type WrittenMapping } from './model/mapping-changes.ts';

/** Attempts to save on top of changes of others. */
const ATTEMPTS = 3;

const LIST = v.array(v.record(v.string(), v.unknown()));

/** The mappings of a bridge, as last received. */
export interface LoadedMappings {
  readonly protocol: string;
  readonly list: readonly WrittenMapping[];
  readonly revision: string;
  /** On the computer of the bridge. */
  readonly file: string;
  readonly fileExists: boolean;
  /** Why the file as it is does not apply; empty when it does. */
  readonly fileProblem: string;
}

/** What became of a change. */
export type SaveResult =
  | { readonly kind: 'saved'; readonly index: number }
  | { readonly kind: 'refused'; readonly problems: readonly BridgeMappingProblem[] }
  /** Another user changed or removed the same mapping. */
  | { readonly kind: 'conflict' }
  | { readonly kind: 'failed'; readonly message: string };

/** What a check found. */
export interface CheckResult {
  readonly problems: readonly BridgeMappingProblem[];
  readonly matches: readonly BridgeMatch[];
  readonly moreMatches: number;
}

export interface BridgeMappingsStore {
  readonly loaded: Readonly<ShallowRef<LoadedMappings | undefined>>;
  /** Why the mappings cannot be loaded, one sentence. */
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  save(change: MappingChange): Promise<SaveResult>;
  /** Checks a change without making it; `undefined` when that is not possible now. */
  check(change: MappingChange): Promise<CheckResult | undefined>;
}

/**
 * The mappings of a bridge, loaded again whenever the bridge says that it has others.
 *
 * @param revision of the newest report
 */
export function useBridgeMappings(
  targetId: string,
  revision: () => string | undefined,
): BridgeMappingsStore {
  const { client, isConnected } = useConnection();
  const loaded = shallowRef<LoadedMappings>();
  const failure = shallowRef<string>();
  let turn = 0;

  async function load(): Promise<void> {
    const own = ++turn;
    try {
      const reply = await client.call('bridgeMappingsGet', { targetId });
      if (own === turn) take(reply);
    } catch (cause) {
      if (own === turn) failure.value = messageOf(cause);
    }
  }
  function take(reply: BridgeMappings): void {
    const list = readStored(LIST, reply.mappingsJson);
    if (list === undefined) {
      failure.value = 'The bridge told mappings that this page cannot read. Reload the page.';
      return;
    }
    const { protocol, revision: now, file, fileExists, fileProblem } = reply;
    loaded.value = { protocol, list, revision: now, file, fileExists, fileProblem };
    failure.value = undefined;
  }
  watch(
    [isConnected, revision] as const,
    ([connected, now]) => {
      if (connected && (now === undefined || now !== loaded.value?.revision)) void load();
    },
    { immediate: true },
  );

  async function saveOnce(change: MappingChange): Promise<SaveResult | 'again'> {
    const before = loaded.value;
    if (before === undefined)
      return { kind: 'failed', message: 'The mappings are not loaded yet.' };
    const changed = applyChange(before.list, change);
    if (changed === undefined) return { kind: 'conflict' };
    const mappingsJson = JSON.stringify(changed.list);
    // Replies to earlier requests are of older mappings.
    turn += 1;
    const reply = await client.call('bridgeMappingsSet', {
      ...{ targetId, mappingsJson, revision: before.revision, clientId: client.id },
    });
    take(reply);
    if (reply.outcome === BridgeOutcome.BRIDGE_OUTCOME_SAVED) {
      return { kind: 'saved', index: changed.index };
    }
    if (reply.outcome === BridgeOutcome.BRIDGE_OUTCOME_REFUSED) {
      const problems = reply.problems.filter(({ index }) => index === changed.index);
      const others = problems.length > 0 ? problems : reply.problems;
      return { kind: 'refused', problems: others };
    }
    if (reply.fileProblem !== '') {
      const message = `The mapping file was edited and has an error, so nothing was saved: ${reply.fileProblem}`;
      return { kind: 'failed', message };
    }
    return 'again';
  }

  return {
    loaded,
    failure,
    async save(change) {
      try {
        for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
          const result = await saveOnce(change);
          if (result !== 'again') return result;
        }
        return { kind: 'conflict' };
      } catch (cause) {
        return { kind: 'failed', message: messageOf(cause) };
      }
    },
    async check(change) {
      const changed = loaded.value && applyChange(loaded.value.list, change);
      if (changed === undefined) return undefined;
      try {
        const reply = await client.call('bridgeMappingsCheck', {
          ...{ targetId, clientId: client.id, previewIndex: changed.index },
          mappingsJson: JSON.stringify(changed.list),
        });
        const problems = reply.problems.filter(({ index }) => index === changed.index);
        return { problems, matches: reply.matches, moreMatches: reply.moreMatches };
      } catch (cause) {
        messageOf(cause);
        return undefined;
      }
    },
  };
}

/** @throws what is no answer of the master */
function messageOf(cause: unknown): string {
  if (cause instanceof ServiceError) return cause.message;
  if (cause instanceof ConnectionError) return 'This page is not connected to the master.';
  throw cause;
}
