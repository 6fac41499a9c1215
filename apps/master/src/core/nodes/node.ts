import {
  NodeExtensionKind,
  ProcessingModuleLanguage,
  type NodeExtension,
  type ProcessingModule,
} from '@ubii/proto';

/** Something that runs modules: the master itself, or a client. */
export interface Node {
  readonly id: string;
  /** Name and id as they stand in messages for people. */
  readonly label: string;
  /** Its capabilities; undefined for clients that do not report them [PM-60]. */
  readonly extension: NodeExtension | undefined;
  /** It exists to run modules for others. */
  readonly isDedicated: boolean;
  /** It can be given modules now. */
  readonly isAvailable: boolean;
  /** Modules it has code for. */
  readonly modules: readonly ProcessingModule[];
}

export function isMaster(node: Node): boolean {
  return node.extension?.kind === NodeExtensionKind.MASTER;
}

/** The module of this name, as the node has it. */
export function offerOf(node: Node, name: string): ProcessingModule | undefined {
  return node.modules.find((module) => module.name === name);
}

/** Why a node cannot run a module, in a few words to follow "it"; undefined when it can. */
export function cannotRun(node: Node, module: ProcessingModule): string | undefined {
  const { extension } = node;
  // A client can run its own modules; the master has modules in all languages, some of which need libraries.
  if (!isMaster(node) && offerOf(node, module.name) !== undefined) return undefined;
  const hasCode = module.onProcessingStringified !== '';
  // Clients of the original run any code of their language, and need not say which modules they have.
  if (extension === undefined) return undefined;
  if (!hasCode) return 'has no module of that name, and the module comes without code';
  if (!extension.runsJavascript) return 'runs only modules it has itself';
  if (!isJavaScript(module)) return 'runs JavaScript only';
  const missing = (module.extension?.libraries ?? []).filter(
    (library) => !extension.libraries.includes(library),
  );
  if (missing.length === 0) {
    const needsAssets = (module.extension?.assets ?? []).length > 0;
    return needsAssets && !extension.loadsAssets ? 'does not load asset sets' : undefined;
  }
  return `has no library ${missing.join(', ')}`;
}

/** Whether the code of a module can be taken for JavaScript; clients that mean no language send that of C++. */
export function isJavaScript({ language }: ProcessingModule): boolean {
  return language === ProcessingModuleLanguage.JS || language === ProcessingModuleLanguage.CPP;
}
