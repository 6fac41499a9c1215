import type { DataFormat, ProcessingModule, TopicDemux, TopicMux } from '@ubii/proto';
import type { JsonObject } from '@ubii/proto';

/** A place on the canvas, in its own units: pixels at a zoom of 1, y downwards. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** One end of a wire. */
export interface PortRef {
  readonly node: string;
  readonly port: string;
}

/** Where values go into a node, or come out of it. */
export interface Port {
  /** Unique within its node. */
  readonly id: string;
  /** For people: the internal name at modules; empty where the node says it all. */
  readonly name: string;
  readonly direction: 'in' | 'out';
  /** Undefined: not known, so that it may be any. */
  readonly format: DataFormat | undefined;
  /** Definition from the session, also for an unknown module. */
  readonly formatText: string;
  /** A list of records, as muxers give and demuxers take. */
  readonly isList: boolean;
  /** False: a mapping names it, the module does not know it. [SE-4] */
  readonly isDeclared: boolean;
  /** Of an input: what the module uses while nothing is connected, such as `{"double":1}`. [PM-5] */
  readonly defaultJson?: string | undefined;
  /** What its values mean, with unit and range, one sentence. [PM-6] */
  readonly description?: string | undefined;
  /** Of an input for a string: the texts that it understands. [PM-7] */
  readonly choices?: readonly string[] | undefined;
}

interface NodeBase {
  readonly id: string;
  /** Top left; undefined: to be laid out. */
  readonly position: Point | undefined;
  /** Undefined: as large as its contents. */
  readonly size: Size | undefined;
  readonly isCollapsed: boolean;
  /** The frame it is in. */
  readonly frame: string | undefined;
  readonly ports: readonly Port[];
}

/** A topic: modules read it from its port `out` and write it at its port `in`. */
export interface TopicNode extends NodeBase {
  readonly kind: 'topic';
  readonly topic: string;
  /** What is known of it from elsewhere; `portFormat` also looks at what is wired to it. */
  readonly format: DataFormat | undefined;
}

/**
 * Whether a module works. Bypassed: what feeds its first fitting input feeds what it fed. Muted: it
 * puts out nothing. Both are not run at all, and keep everything they are.
 */
export type Standing = 'active' | 'bypassed' | 'muted';

export interface ModuleNode extends NodeBase {
  readonly kind: 'module';
  readonly module: ProcessingModule;
  /** Constants that stand at inputs themselves, as JSON text by input name. [PM-34] */
  readonly constants: ReadonlyMap<string, string>;
  readonly standing: Standing;
}

/** Many topics as one list. [PM-41] */
export interface MuxerNode extends NodeBase {
  readonly kind: 'muxer';
  readonly mux: TopicMux;
}

/** One list to many topics. [PM-45] */
export interface DemuxerNode extends NodeBase {
  readonly kind: 'demuxer';
  readonly demux: TopicDemux;
}

/** A value that any number of inputs take. [PM-34] */
export interface ConstantNode extends NodeBase {
  readonly kind: 'constant';
  readonly name: string;
  /** Text of one record member, such as `{"double":1}`. */
  readonly json: string;
}

export interface CommentNode extends NodeBase {
  readonly kind: 'comment';
  readonly text: string;
}

/** A titled area; the nodes in it name it. */
export interface FrameNode extends NodeBase {
  readonly kind: 'frame';
  readonly title: string;
  /** One of `FRAME_COLORS`; others are kept and not shown; empty: none. */
  readonly color: string;
}

export type GraphNode =
  TopicNode | ModuleNode | MuxerNode | DemuxerNode | ConstantNode | CommentNode | FrameNode;
export type NodeKind = GraphNode['kind'];

/** From an output port to an input port. */
export interface Wire {
  readonly id: string;
  readonly from: PortRef;
  readonly to: PortRef;
  /**
   * From module to module: the topic in between, which has no node of its own. All wires from one
   * output to other modules share it.
   */
  readonly via: string | undefined;
  /** Points it is led through, from its start to its end. */
  readonly points: readonly Point[];
}

/** What people say about the session as a whole. */
export interface SessionDetails {
  readonly name: string;
  readonly description: string;
  readonly tags: readonly string[];
  readonly authors: readonly string[];
  readonly editable: boolean;
  readonly startWithMaster: boolean;
  /** 0: the master's default. [SE-40] */
  readonly lockstepHertz: number;
}

/** A session as a graph. Never changed: commands make a new one that shares what is the same. */
export interface Graph {
  readonly nodes: ReadonlyMap<string, GraphNode>;
  readonly wires: ReadonlyMap<string, Wire>;
  readonly details: SessionDetails;
  /** What the session's editor data also says and this program does not understand: kept. */
  readonly foreign: JsonObject;
}

/** The id of a wire follows from its ends, so that a session always gives the same graph. */
export function wireId(from: PortRef, to: PortRef): string {
  return `${from.node} ${from.port} > ${to.node} ${to.port}`;
}
