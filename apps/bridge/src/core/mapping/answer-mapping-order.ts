import { BridgeOutcome, ServiceError } from '@ubii/proto';
import type { BridgeMappings, BridgeMappingsChange, BridgeOrder, Init } from '@ubii/proto';
import { BRIDGE_LIMITS } from '../limits.ts';
import { findMappingProblems } from './find-mapping-problems.ts';
import type { MappingStore } from './mapping-store.ts';
import { previewMapping } from './preview-mapping.ts';
import type { Present } from './preview-mapping.ts';

/** What orders of the master are answered with. */
export interface MappingOrderContext {
  readonly store: MappingStore;
  /** What there is at both sides now. */
  present(): Promise<Present>;
  /** The mappings were changed by a page. @param author name of its client */
  onSaved(author: string): void;
}

const OUTCOMES = {
  saved: BridgeOutcome.BRIDGE_OUTCOME_SAVED,
  refused: BridgeOutcome.BRIDGE_OUTCOME_REFUSED,
  conflict: BridgeOutcome.BRIDGE_OUTCOME_CONFLICT,
};

/**
 * Does what the master asks on behalf of a page. Whether the page may ask, the master has checked. [BR-80]
 *
 * @throws ServiceError when the order cannot be read, or the file cannot be written
 */
export async function answerMappingOrder(
  context: MappingOrderContext,
  { get, check, set, author }: BridgeOrder,
): Promise<Init<BridgeMappings>> {
  if (get !== undefined) return describe(context.store);
  if (check !== undefined) return checkMappings(context, check);
  if (set !== undefined) return saveMappings(context, set, author);
  throw new ServiceError('unimplemented', 'This version of the bridge does not know the request.');
}

function describe(store: MappingStore): Init<BridgeMappings> {
  store.refresh();
  const { protocol, revision, path: file, fileExists, fileProblem } = store;
  return {
    protocol,
    revision,
    file,
    fileExists,
    fileProblem,
    mappingsJson: JSON.stringify(store.written),
  };
}

/** [BR-81] */
async function checkMappings(
  { store, present }: MappingOrderContext,
  { mappingsJson, previewIndex }: BridgeMappingsChange,
): Promise<Init<BridgeMappings>> {
  const { problems, mappings } = findMappingProblems(parseList(mappingsJson), store.protocol);
  const { protocol, revision } = store;
  const previewed = mappings[previewIndex];
  if (previewed === undefined) return { protocol, revision, problems };
  const { matches, more: moreMatches } = previewMapping(previewed, await present());
  return { protocol, revision, problems, matches, moreMatches };
}

/** [BR-82] */
function saveMappings(
  { store, onSaved }: MappingOrderContext,
  { mappingsJson, revision }: BridgeMappingsChange,
  author: string,
): Init<BridgeMappings> {
  const list = parseList(mappingsJson);
  let saved: ReturnType<MappingStore['save']>;
  try {
    saved = store.save(list, revision);
  } catch (error) {
    const text = `The mapping file ${store.path} cannot be written: ${(error as Error).message}. Nothing has changed.`;
    throw new ServiceError('failed_precondition', text);
  }
  if (saved.outcome === 'saved') onSaved(author);
  return {
    ...describe(store),
    outcome: OUTCOMES[saved.outcome],
    problems: saved.outcome === 'refused' ? saved.problems : [],
  };
}

/** @throws ServiceError when it is no list */
function parseList(json: string): readonly unknown[] {
  let list: unknown;
  try {
    list = json.length > BRIDGE_LIMITS.mappingFileChars ? undefined : JSON.parse(json);
  } catch {
    list = undefined;
  }
  if (Array.isArray(list) && list.length <= BRIDGE_LIMITS.mappings) return list;
  throw new ServiceError(
    'invalid_argument',
    `The member mappings_json must be a list of at most ${BRIDGE_LIMITS.mappings} mappings, as JSON.`,
  );
}
