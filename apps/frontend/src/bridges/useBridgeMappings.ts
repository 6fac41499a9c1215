import { ConnectionError } from '@ubii/client-web';
import {
  BridgeOutcome,
  type BridgeMappingProblem,
  type BridgeMappings,
  type BridgeMatch,
} from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import * as v from 'valibot';
import { tryRequest, type RequestError } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';
import { readStored } from '../json/read-stored.ts';
import { applyChange, type MappingChange, type WrittenMapping } from './model/mapping-changes.ts';

/** Tries to save on top of changes of others. */
const MAX_TRIES = 3;

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
    const reply = await tryRequest(
      () => client.call('bridgeMappingsGet', { targetId }),
      (cause) => {
        if (own === turn) failure.value = sentenceOf(cause);
      },
    );
    if (reply && own === turn) take(reply);
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
      targetId,
      mappingsJson,
      revision: before.revision,
      clientId: client.id,
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

  async function saveOnTop(change: MappingChange): Promise<SaveResult> {
    for (let tries = 0; tries < MAX_TRIES; tries++) {
      const result = await saveOnce(change);
      if (result !== 'again') return result;
    }
    return { kind: 'conflict' };
  }

  return {
    loaded,
    failure,
    async save(change) {
      let message = '';
      const result = await tryRequest(
        () => saveOnTop(change),
        (cause) => (message = sentenceOf(cause)),
      );
      return result ?? { kind: 'failed', message };
    },
    async check(change) {
      const changed = loaded.value && applyChange(loaded.value.list, change);
      if (changed === undefined) return undefined;
      const reply = await tryRequest(() =>
        client.call('bridgeMappingsCheck', {
          targetId,
          clientId: client.id,
          previewIndex: changed.index,
          mappingsJson: JSON.stringify(changed.list),
        }),
      );
      if (reply === undefined) return undefined;
      const problems = reply.problems.filter(({ index }) => index === changed.index);
      return { problems, matches: reply.matches, moreMatches: reply.moreMatches };
    },
  };
}

function sentenceOf(cause: RequestError): string {
  return cause instanceof ConnectionError
    ? 'This page is not connected to the master.'
    : cause.message;
}
