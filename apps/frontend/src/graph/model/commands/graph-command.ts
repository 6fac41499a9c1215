import type { ProcessingModule, TopicDemux, TopicMux } from '@ubii/proto';
import type {
  FrameNode,
  GraphNode,
  Point,
  PortRef,
  SessionDetails,
  Size,
  Standing,
  Wire,
} from '../graph.ts';
import type { GraphPatch } from './graph-edit.ts';

/** Edit of a graph. Commands that refer to missing elements have no effect. */
export type GraphCommand =
  /** Several commands as one step, with its label. */
  | { readonly kind: 'all'; readonly commands: readonly GraphCommand[]; readonly label: string }
  | { readonly kind: 'patch'; readonly patch: GraphPatch; readonly label: string }
  | {
      readonly kind: 'add';
      readonly nodes: readonly GraphNode[];
      readonly wires?: readonly Wire[];
      readonly label?: string;
    }
  | {
      readonly kind: 'remove';
      readonly nodes?: readonly string[];
      readonly wires?: readonly string[];
    }
  | { readonly kind: 'move'; readonly positions: ReadonlyMap<string, Point> }
  | {
      readonly kind: 'resize';
      readonly node: string;
      readonly size: Size | undefined;
      readonly position?: Point;
    }
  | { readonly kind: 'collapse'; readonly nodes: readonly string[]; readonly isCollapsed: boolean }
  /** Adds a wire; to an input that has one, replaces it. */
  | {
      readonly kind: 'connect';
      readonly from: PortRef;
      readonly to: PortRef;
      /** Topic of a wire between modules; default: an existing or generated one. */
      readonly via?: string;
    }
  | { readonly kind: 'reroute'; readonly wire: string; readonly points: readonly Point[] }
  | {
      readonly kind: 'setModule';
      readonly node: string;
      readonly changes: Partial<ProcessingModule>;
    }
  /** Sets a value at an input; undefined: the default of the module. */
  | {
      readonly kind: 'setConstant';
      readonly node: string;
      readonly input: string;
      readonly json: string | undefined;
    }
  /** Bypasses, mutes or enables modules. */
  | {
      readonly kind: 'setStanding';
      readonly nodes: readonly string[];
      readonly standing: Standing;
    }
  | { readonly kind: 'setMuxer'; readonly node: string; readonly changes: Partial<TopicMux> }
  | { readonly kind: 'setDemuxer'; readonly node: string; readonly changes: Partial<TopicDemux> }
  /** Sets the value of a constant node. */
  | { readonly kind: 'setValue'; readonly node: string; readonly json: string }
  /** Sets the text of a comment, the title of a frame or the name of a constant. */
  | { readonly kind: 'setText'; readonly node: string; readonly text: string }
  /** One of `FRAME_COLORS`, or empty. */
  | { readonly kind: 'setColor'; readonly frame: string; readonly color: string }
  | { readonly kind: 'renameTopic'; readonly node: string; readonly topic: string }
  /** Changes the topic between two modules, for all wires that share it. */
  | { readonly kind: 'setVia'; readonly wire: string; readonly topic: string }
  /** Replaces topics that others use by topics of this session. */
  | { readonly kind: 'ownTopics'; readonly topics: readonly string[] }
  /** Adds a node for the topic of a wire between modules. */
  | { readonly kind: 'showTopic'; readonly wire: string; readonly position?: Point | undefined }
  /** Replaces the node of a topic that one module writes and others read by wires. */
  | { readonly kind: 'hideTopic'; readonly node: string }
  | { readonly kind: 'group'; readonly frame: FrameNode; readonly nodes: readonly string[] }
  | { readonly kind: 'ungroup'; readonly frame: string }
  | {
      readonly kind: 'setFrame';
      readonly nodes: readonly string[];
      readonly frame: string | undefined;
    }
  | { readonly kind: 'setDetails'; readonly changes: Partial<SessionDetails> };

export type CommandKind = GraphCommand['kind'];
export type CommandOf<K extends CommandKind> = Extract<GraphCommand, { readonly kind: K }>;
