import type { DataFormat, ProcessingModule, TopicDemux, TopicMux } from '@ubii/proto';
import type { JsonObject } from '@ubii/proto';

/** Position on the canvas, in canvas units: pixels at a zoom of 1, y downwards. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Reference to a port. */
export interface PortRef {
  readonly node: string;
  readonly port: string;
}

/** Input or output of a node. */
export interface Port {
  /** Unique within its node. */
  readonly id: string;
  /** Display name: the internal name for modules; empty for nodes with one port. */
  readonly name: string;
  readonly direction: 'in' | 'out';
  /** Undefined: unknown, and possibly any. */
  readonly format: DataFormat | undefined;
  /** Definition from the session, also for an unknown module. */
  readonly formatText: string;
  /** True for a list of records, which muxers output and demuxers read. */
  readonly isList: boolean;
  /** False for ports that occur in a mapping only, and not in the module. [SE-4] */
  readonly isDeclared: boolean;
  /** Of an input: value that the module uses without a connection, such as `{"double":1}`. [PM-5] */
  readonly defaultJson?: string | undefined;
  /** Meaning of its values, with unit and range, one sentence. [PM-6] */
  readonly description?: string | undefined;
  /** Of a string input: the accepted texts. [PM-7] */
  readonly choices?: readonly string[] | undefined;
}

interface NodeBase {
  readonly id: string;
  /** Top left; undefined: set by the layout. */
  readonly position: Point | undefined;
  /** Undefined: the size of its contents. */
  readonly size: Size | undefined;
  readonly isCollapsed: boolean;
  /** Id of the frame that contains it. */
  readonly frame: string | undefined;
  readonly ports: readonly Port[];
}

/** A topic: modules read it from its port `out` and write it at its port `in`. */
export interface TopicNode extends NodeBase {
  readonly kind: 'topic';
  readonly topic: string;
  /** Known data format; `portFormat` also considers the connected ports. */
  readonly format: DataFormat | undefined;
}

/**
 * Whether a module runs. Bypassed: the source of its first fitting input is connected to its targets. Muted: it has no
 * output. Bypassed and muted modules do not run, and keep all their settings.
 */
export type Standing = 'active' | 'bypassed' | 'muted';

export interface ModuleNode extends NodeBase {
  readonly kind: 'module';
  readonly module: ProcessingModule;
  /** Constants set at inputs, as JSON text by input name. [PM-34] */
  readonly constants: ReadonlyMap<string, string>;
  readonly standing: Standing;
}

/** Muxer: several topics as one list. [PM-41] */
export interface MuxerNode extends NodeBase {
  readonly kind: 'muxer';
  readonly mux: TopicMux;
}

/** Demuxer: one list to several topics. [PM-45] */
export interface DemuxerNode extends NodeBase {
  readonly kind: 'demuxer';
  readonly demux: TopicDemux;
}

/** Constant for any number of inputs. [PM-34] */
export interface ConstantNode extends NodeBase {
  readonly kind: 'constant';
  readonly name: string;
  /** JSON text of one record member, such as `{"double":1}`. */
  readonly json: string;
}

export interface CommentNode extends NodeBase {
  readonly kind: 'comment';
  readonly text: string;
}

/** Titled area; nodes refer to the frame they are in. */
export interface FrameNode extends NodeBase {
  readonly kind: 'frame';
  readonly title: string;
  /** One of `FRAME_COLORS`; other values are kept and not shown; empty: none. */
  readonly color: string;
}

export type GraphNode =
  | TopicNode
  | ModuleNode
  | MuxerNode
  | DemuxerNode
  | ConstantNode
  | CommentNode
  | FrameNode;
export type NodeKind = GraphNode['kind'];

/** Connection from an output port to an input port. */
export interface Wire {
  readonly id: string;
  readonly from: PortRef;
  readonly to: PortRef;
  /** Topic of a wire between modules, which has no node. All wires from one output to other modules share it. */
  readonly via: string | undefined;
  /** Bend points, from its start to its end. */
  readonly points: readonly Point[];
}

/** Properties of the session as a whole. */
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

/** Session as a graph. Immutable: commands return a new one that shares unchanged elements. */
export interface Graph {
  readonly nodes: ReadonlyMap<string, GraphNode>;
  readonly wires: ReadonlyMap<string, Wire>;
  readonly details: SessionDetails;
  /** Members of the session's editor data that this program does not know; kept unchanged. */
  readonly foreign: JsonObject;
}

/** Ids of wires are derived from their ends, so that equal sessions give equal graphs. */
export function wireId(from: PortRef, to: PortRef): string {
  return `${from.node} ${from.port} > ${to.node} ${to.port}`;
}
