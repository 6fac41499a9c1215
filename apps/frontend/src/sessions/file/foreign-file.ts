/** Description of a JSON value that users may take for a session. */
export interface Foreign {
  /** With its article: `a Node-RED flow`. */
  readonly what: string;
  /** Recommended action, one sentence; may be empty. */
  readonly advice: string;
}

type Members = Readonly<Record<string, unknown>>;

/** Recognises files of other programs, and other files of this one. */
export function recogniseForeign(value: unknown): Foreign | undefined {
  if (Array.isArray(value)) return recogniseList(value);
  if (!isMembers(value)) return undefined;
  if (isSessionLike(value)) return undefined;
  const found = KNOWN.find(({ test }) => test(value));
  return found && { what: found.what, advice: found.advice ?? NO_WAY };
}

const NO_WAY = 'Its nodes have no equivalent in Ubi-Interact.';

const isMembers = (value: unknown): value is Members =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const has = (value: Members, ...names: readonly string[]): boolean =>
  names.every((name) => Object.hasOwn(value, name));

/** True for objects with a member that only sessions have. */
export function isSessionLike(value: Members): boolean {
  return ['processingModules', 'processing_modules', 'ioMappings', 'io_mappings'].some((name) =>
    has(value, name),
  );
}

function recogniseList(list: readonly unknown[]): Foreign | undefined {
  const nodes = list.filter(isMembers);
  if (nodes.length === 0) return undefined;
  if (nodes.some((node) => has(node, 'id', 'type') && (has(node, 'wires') || has(node, 'z')))) {
    return { what: 'a Node-RED flow', advice: NO_WAY };
  }
  if (nodes.every(isSessionLike)) {
    return {
      what: 'a list of sessions',
      advice: 'Save each session as a separate file.',
    };
  }
  return undefined;
}

const KNOWN: readonly {
  readonly what: string;
  readonly advice?: string;
  readonly test: (value: Members) => boolean;
}[] = [
  {
    what: 'nodes copied from a graph',
    advice: 'Paste the text into a graph.',
    test: ({ format }) => format === 'ubi-interact.nodes',
  },
  {
    what: 'a module file',
    advice: 'Import it on the Modules page.',
    test: (value) =>
      has(value, 'onProcessingStringified') ||
      has(value, 'on_processing_stringified') ||
      (has(value, 'name') && (has(value, 'processingMode') || has(value, 'inputs', 'outputs'))),
  },
  {
    what: 'a ComfyUI workflow',
    test: (value) => Array.isArray(value.nodes) && Array.isArray(value.links),
  },
  {
    what: 'a ComfyUI workflow',
    test: (value) => {
      const nodes = Object.values(value);
      return nodes.length > 0 && nodes.every((node) => isMembers(node) && has(node, 'class_type'));
    },
  },
  { what: 'a cables.gl patch', test: (value) => Array.isArray(value.ops) },
  { what: 'a Node-RED flow', test: (value) => Array.isArray(value.flows) },
  {
    what: 'a recording',
    advice: 'The file contains values, not a session.',
    test: (value) => has(value, 'topicDataRecordList') || has(value, 'records'),
  },
  {
    what: 'a package.json',
    advice: 'The file belongs to another program.',
    test: (value) => has(value, 'name', 'version') && has(value, 'dependencies'),
  },
];
