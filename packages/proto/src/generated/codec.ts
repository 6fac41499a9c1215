// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.

import type { Init } from '../init.ts';
import { only, open, readBytes, readInt64, setMember, skip, writeBytes, writeString, type Reader, type Writer } from '../protobuf.ts';
import type * as T from './messages.ts';

export function encodeClient(m: Init<T.Client>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.devices != null) for (const e of m.devices) { w.uint32(26).fork(); encodeDevice(e, w); w.ldelim(); }
  if (m.tags != null) for (const e of m.tags) writeString(w.uint32(34), e);
  if (m.description != null) writeString(w.uint32(42), m.description);
  if (m.processingModules != null) for (const e of m.processingModules) { w.uint32(50).fork(); encodeProcessingModule(e, w); w.ldelim(); }
  if (m.isDedicatedProcessingNode != null) w.uint32(56).bool(m.isDedicatedProcessingNode);
  if (m.hostIp != null) writeString(w.uint32(66), m.hostIp);
  if (m.metadataJson != null) writeString(w.uint32(74), m.metadataJson);
  if (m.state != null) w.uint32(80).int32(m.state);
  if (m.latency != null) w.uint32(93).float(m.latency);
  if (m.extension != null) { w.uint32(8002).fork(); encodeClientExtension(m.extension, w); w.ldelim(); }
}

export function decodeClient(r: Reader, into?: T.Client): T.Client {
  const m: T.Client = into ?? { id: '', name: '', devices: [], tags: [], description: '', processingModules: [], isDedicatedProcessingNode: false, hostIp: '', metadataJson: '', state: 0, latency: 0, extension: undefined };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: { const end = open(r); m.devices.push(decodeDevice(r)); r.len = end; break; }
      case 34: m.tags.push(r.stringVerify()); break;
      case 42: m.description = r.stringVerify(); break;
      case 50: { const end = open(r); m.processingModules.push(decodeProcessingModule(r)); r.len = end; break; }
      case 56: m.isDedicatedProcessingNode = r.bool(); break;
      case 66: m.hostIp = r.stringVerify(); break;
      case 74: m.metadataJson = r.stringVerify(); break;
      case 80: m.state = r.int32() as T.ClientState; break;
      case 93: m.latency = r.float(); break;
      case 8002: { const end = open(r); m.extension = decodeClientExtension(r, m.extension); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeClientList(m: Init<T.ClientList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeClient(e, w); w.ldelim(); }
}

export function decodeClientList(r: Reader, into?: T.ClientList): T.ClientList {
  const m: T.ClientList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeClient(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeNotifyCondition(m: Init<T.NotifyCondition>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.evaluationFunctionStringified != null) writeString(w.uint32(26), m.evaluationFunctionStringified);
  if (m.clientProfilePub != null) { w.uint32(34).fork(); encodeClient(m.clientProfilePub, w); w.ldelim(); }
  if (m.clientProfileSub != null) { w.uint32(42).fork(); encodeClient(m.clientProfileSub, w); w.ldelim(); }
}

export function decodeNotifyCondition(r: Reader, into?: T.NotifyCondition): T.NotifyCondition {
  const m: T.NotifyCondition = into ?? { id: '', name: '', evaluationFunctionStringified: '', clientProfilePub: undefined, clientProfileSub: undefined };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: m.evaluationFunctionStringified = r.stringVerify(); break;
      case 34: { const end = open(r); m.clientProfilePub = decodeClient(r, m.clientProfilePub); r.len = end; break; }
      case 42: { const end = open(r); m.clientProfileSub = decodeClient(r, m.clientProfileSub); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeBoolList(m: Init<T.BoolList>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.uint32(10).bools(m.elements as boolean[]);
}

export function decodeBoolList(r: Reader, into?: T.BoolList): T.BoolList {
  const m: T.BoolList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.elements.push(r.bool()); break;
      case 10: r.bools(m.elements); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeColor(m: Init<T.Color>, w: Writer): void {
  if (m.r != null) w.uint32(9).double(m.r);
  if (m.g != null) w.uint32(17).double(m.g);
  if (m.b != null) w.uint32(25).double(m.b);
  if (m.a != null) w.uint32(33).double(m.a);
}

export function decodeColor(r: Reader, into?: T.Color): T.Color {
  const m: T.Color = into ?? { r: 0, g: 0, b: 0, a: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.r = r.double(); break;
      case 17: m.g = r.double(); break;
      case 25: m.b = r.double(); break;
      case 33: m.a = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeDoubleList(m: Init<T.DoubleList>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.uint32(10).doubles(m.elements as number[]);
}

export function decodeDoubleList(r: Reader, into?: T.DoubleList): T.DoubleList {
  const m: T.DoubleList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.elements.push(r.double()); break;
      case 10: r.doubles(m.elements); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeFloatList(m: Init<T.FloatList>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.uint32(10).floats(m.elements as number[]);
}

export function decodeFloatList(r: Reader, into?: T.FloatList): T.FloatList {
  const m: T.FloatList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 13: m.elements.push(r.float()); break;
      case 10: r.floats(m.elements); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeImage2D(m: Init<T.Image2D>, w: Writer): void {
  if (m.width != null) w.uint32(8).int32(m.width);
  if (m.height != null) w.uint32(16).int32(m.height);
  if (m.dataFormat != null) w.uint32(24).int32(m.dataFormat);
  if (m.data != null) writeBytes(w.uint32(34), m.data);
}

export function decodeImage2D(r: Reader, into?: T.Image2D): T.Image2D {
  const m: T.Image2D = into ?? { width: 0, height: 0, dataFormat: 0, data: new Uint8Array(0) };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.width = r.int32(); break;
      case 16: m.height = r.int32(); break;
      case 24: m.dataFormat = r.int32() as T.Image2DDataFormat; break;
      case 34: m.data = readBytes(r); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeImage2DList(m: Init<T.Image2DList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeImage2D(e, w); w.ldelim(); }
}

export function decodeImage2DList(r: Reader, into?: T.Image2DList): T.Image2DList {
  const m: T.Image2DList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeImage2D(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeInt32List(m: Init<T.Int32List>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.uint32(10).int32s(m.elements as number[]);
}

export function decodeInt32List(r: Reader, into?: T.Int32List): T.Int32List {
  const m: T.Int32List = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.elements.push(r.int32()); break;
      case 10: r.int32s(m.elements); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeKeyEvent(m: Init<T.KeyEvent>, w: Writer): void {
  if (m.type != null) w.uint32(8).int32(m.type);
  if (m.key != null) writeString(w.uint32(18), m.key);
}

export function decodeKeyEvent(r: Reader, into?: T.KeyEvent): T.KeyEvent {
  const m: T.KeyEvent = into ?? { type: 0, key: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.type = r.int32() as T.ButtonEventType; break;
      case 18: m.key = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMatrix3x2(m: Init<T.Matrix3x2>, w: Writer): void {
  if (m.m00 != null) w.uint32(9).double(m.m00);
  if (m.m01 != null) w.uint32(17).double(m.m01);
  if (m.m10 != null) w.uint32(25).double(m.m10);
  if (m.m11 != null) w.uint32(33).double(m.m11);
  if (m.m20 != null) w.uint32(41).double(m.m20);
  if (m.m21 != null) w.uint32(49).double(m.m21);
}

export function decodeMatrix3x2(r: Reader, into?: T.Matrix3x2): T.Matrix3x2 {
  const m: T.Matrix3x2 = into ?? { m00: 0, m01: 0, m10: 0, m11: 0, m20: 0, m21: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.m00 = r.double(); break;
      case 17: m.m01 = r.double(); break;
      case 25: m.m10 = r.double(); break;
      case 33: m.m11 = r.double(); break;
      case 41: m.m20 = r.double(); break;
      case 49: m.m21 = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMatrix4x4(m: Init<T.Matrix4x4>, w: Writer): void {
  if (m.m00 != null) w.uint32(9).double(m.m00);
  if (m.m01 != null) w.uint32(17).double(m.m01);
  if (m.m02 != null) w.uint32(25).double(m.m02);
  if (m.m03 != null) w.uint32(33).double(m.m03);
  if (m.m10 != null) w.uint32(41).double(m.m10);
  if (m.m11 != null) w.uint32(49).double(m.m11);
  if (m.m12 != null) w.uint32(57).double(m.m12);
  if (m.m13 != null) w.uint32(65).double(m.m13);
  if (m.m20 != null) w.uint32(73).double(m.m20);
  if (m.m21 != null) w.uint32(81).double(m.m21);
  if (m.m22 != null) w.uint32(89).double(m.m22);
  if (m.m23 != null) w.uint32(97).double(m.m23);
  if (m.m30 != null) w.uint32(105).double(m.m30);
  if (m.m31 != null) w.uint32(113).double(m.m31);
  if (m.m32 != null) w.uint32(121).double(m.m32);
  if (m.m33 != null) w.uint32(129).double(m.m33);
}

export function decodeMatrix4x4(r: Reader, into?: T.Matrix4x4): T.Matrix4x4 {
  const m: T.Matrix4x4 = into ?? { m00: 0, m01: 0, m02: 0, m03: 0, m10: 0, m11: 0, m12: 0, m13: 0, m20: 0, m21: 0, m22: 0, m23: 0, m30: 0, m31: 0, m32: 0, m33: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.m00 = r.double(); break;
      case 17: m.m01 = r.double(); break;
      case 25: m.m02 = r.double(); break;
      case 33: m.m03 = r.double(); break;
      case 41: m.m10 = r.double(); break;
      case 49: m.m11 = r.double(); break;
      case 57: m.m12 = r.double(); break;
      case 65: m.m13 = r.double(); break;
      case 73: m.m20 = r.double(); break;
      case 81: m.m21 = r.double(); break;
      case 89: m.m22 = r.double(); break;
      case 97: m.m23 = r.double(); break;
      case 105: m.m30 = r.double(); break;
      case 113: m.m31 = r.double(); break;
      case 121: m.m32 = r.double(); break;
      case 129: m.m33 = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMouseEventMessage(m: Init<T.MouseEventMessage>, w: Writer): void {
  if (m.type != null) w.uint32(8).int32(m.type);
  if (m.button != null) w.uint32(16).int32(m.button);
}

export function decodeMouseEventMessage(r: Reader, into?: T.MouseEventMessage): T.MouseEventMessage {
  const m: T.MouseEventMessage = into ?? { type: 0, button: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.type = r.int32() as T.ButtonEventType; break;
      case 16: m.button = r.int32(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMyoEvent(m: Init<T.MyoEvent>, w: Writer): void {
  if (m.emg != null) { w.uint32(10).fork(); encodeVector8(m.emg, w); w.ldelim(); }
  if (m.orientation != null) { w.uint32(18).fork(); encodeQuaternion(m.orientation, w); w.ldelim(); }
  if (m.gyroscope != null) { w.uint32(26).fork(); encodeVector3(m.gyroscope, w); w.ldelim(); }
  if (m.accelerometer != null) { w.uint32(34).fork(); encodeVector3(m.accelerometer, w); w.ldelim(); }
  if (m.gesture != null) w.uint32(40).int32(m.gesture);
}

export function decodeMyoEvent(r: Reader, into?: T.MyoEvent): T.MyoEvent {
  const m: T.MyoEvent = into ?? { emg: undefined, orientation: undefined, gyroscope: undefined, accelerometer: undefined, gesture: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.emg = decodeVector8(r, m.emg); r.len = end; break; }
      case 18: { const end = open(r); m.orientation = decodeQuaternion(r, m.orientation); r.len = end; break; }
      case 26: { const end = open(r); m.gyroscope = decodeVector3(r, m.gyroscope); r.len = end; break; }
      case 34: { const end = open(r); m.accelerometer = decodeVector3(r, m.accelerometer); r.len = end; break; }
      case 40: m.gesture = r.int32() as T.HandGestureType; break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeObject2D(m: Init<T.Object2D>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.pose != null) { w.uint32(18).fork(); encodePose2D(m.pose, w); w.ldelim(); }
  if (m.size != null) { w.uint32(26).fork(); encodeVector2(m.size, w); w.ldelim(); }
  if (m.userDataJson != null) writeString(w.uint32(34), m.userDataJson);
}

export function decodeObject2D(r: Reader, into?: T.Object2D): T.Object2D {
  const m: T.Object2D = into ?? { id: '', pose: undefined, size: undefined, userDataJson: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: { const end = open(r); m.pose = decodePose2D(r, m.pose); r.len = end; break; }
      case 26: { const end = open(r); m.size = decodeVector2(r, m.size); r.len = end; break; }
      case 34: m.userDataJson = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeObject2DList(m: Init<T.Object2DList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeObject2D(e, w); w.ldelim(); }
}

export function decodeObject2DList(r: Reader, into?: T.Object2DList): T.Object2DList {
  const m: T.Object2DList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeObject2D(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeObject3D(m: Init<T.Object3D>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.pose != null) { w.uint32(18).fork(); encodePose3D(m.pose, w); w.ldelim(); }
  if (m.size != null) { w.uint32(26).fork(); encodeVector3(m.size, w); w.ldelim(); }
  if (m.userDataJson != null) writeString(w.uint32(34), m.userDataJson);
}

export function decodeObject3D(r: Reader, into?: T.Object3D): T.Object3D {
  const m: T.Object3D = into ?? { id: '', pose: undefined, size: undefined, userDataJson: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: { const end = open(r); m.pose = decodePose3D(r, m.pose); r.len = end; break; }
      case 26: { const end = open(r); m.size = decodeVector3(r, m.size); r.len = end; break; }
      case 34: m.userDataJson = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeObject3DList(m: Init<T.Object3DList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeObject3D(e, w); w.ldelim(); }
}

export function decodeObject3DList(r: Reader, into?: T.Object3DList): T.Object3DList {
  const m: T.Object3DList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeObject3D(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodePose2D(m: Init<T.Pose2D>, w: Writer): void {
  if (m.position != null) { w.uint32(10).fork(); encodeVector2(m.position, w); w.ldelim(); }
  if (m.direction != null) { w.uint32(18).fork(); encodeVector2(m.direction, w); w.ldelim(); }
  if (m.angle != null) w.uint32(29).float(m.angle);
}

const Pose2D_orientation = ['direction', 'angle'] as const;
export function decodePose2D(r: Reader, into?: T.Pose2D): T.Pose2D {
  const m: T.Pose2D = into ?? { position: undefined };
  let orientation = into && setMember(into, Pose2D_orientation);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.position = decodeVector2(r, m.position); r.len = end; break; }
      case 18: orientation = only(m, orientation, 'direction'); { const end = open(r); m.direction = decodeVector2(r, m.direction); r.len = end; break; }
      case 29: orientation = only(m, orientation, 'angle'); m.angle = r.float(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodePose3D(m: Init<T.Pose3D>, w: Writer): void {
  if (m.position != null) { w.uint32(10).fork(); encodeVector3(m.position, w); w.ldelim(); }
  if (m.quaternion != null) { w.uint32(18).fork(); encodeQuaternion(m.quaternion, w); w.ldelim(); }
  if (m.euler != null) { w.uint32(26).fork(); encodeVector3(m.euler, w); w.ldelim(); }
}

const Pose3D_orientation = ['quaternion', 'euler'] as const;
export function decodePose3D(r: Reader, into?: T.Pose3D): T.Pose3D {
  const m: T.Pose3D = into ?? { position: undefined };
  let orientation = into && setMember(into, Pose3D_orientation);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.position = decodeVector3(r, m.position); r.len = end; break; }
      case 18: orientation = only(m, orientation, 'quaternion'); { const end = open(r); m.quaternion = decodeQuaternion(r, m.quaternion); r.len = end; break; }
      case 26: orientation = only(m, orientation, 'euler'); { const end = open(r); m.euler = decodeVector3(r, m.euler); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeQuaternion(m: Init<T.Quaternion>, w: Writer): void {
  if (m.x != null) w.uint32(9).double(m.x);
  if (m.y != null) w.uint32(17).double(m.y);
  if (m.z != null) w.uint32(25).double(m.z);
  if (m.w != null) w.uint32(33).double(m.w);
}

export function decodeQuaternion(r: Reader, into?: T.Quaternion): T.Quaternion {
  const m: T.Quaternion = into ?? { x: 0, y: 0, z: 0, w: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      case 25: m.z = r.double(); break;
      case 33: m.w = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeQuaternionList(m: Init<T.QuaternionList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeQuaternion(e, w); w.ldelim(); }
}

export function decodeQuaternionList(r: Reader, into?: T.QuaternionList): T.QuaternionList {
  const m: T.QuaternionList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeQuaternion(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeStringList(m: Init<T.StringList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) writeString(w.uint32(10), e);
}

export function decodeStringList(r: Reader, into?: T.StringList): T.StringList {
  const m: T.StringList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.elements.push(r.stringVerify()); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTouchEventMessage(m: Init<T.TouchEventMessage>, w: Writer): void {
  if (m.type != null) w.uint32(8).int32(m.type);
  if (m.position != null) { w.uint32(18).fork(); encodeVector2(m.position, w); w.ldelim(); }
  if (m.id != null) writeString(w.uint32(26), m.id);
  if (m.force != null) w.uint32(37).float(m.force);
}

export function decodeTouchEventMessage(r: Reader, into?: T.TouchEventMessage): T.TouchEventMessage {
  const m: T.TouchEventMessage = into ?? { type: 0, position: undefined, id: '', force: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.type = r.int32() as T.TouchEventType; break;
      case 18: { const end = open(r); m.position = decodeVector2(r, m.position); r.len = end; break; }
      case 26: m.id = r.stringVerify(); break;
      case 37: m.force = r.float(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTouchEventList(m: Init<T.TouchEventList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTouchEventMessage(e, w); w.ldelim(); }
}

export function decodeTouchEventList(r: Reader, into?: T.TouchEventList): T.TouchEventList {
  const m: T.TouchEventList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTouchEventMessage(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector2(m: Init<T.Vector2>, w: Writer): void {
  if (m.x != null) w.uint32(9).double(m.x);
  if (m.y != null) w.uint32(17).double(m.y);
}

export function decodeVector2(r: Reader, into?: T.Vector2): T.Vector2 {
  const m: T.Vector2 = into ?? { x: 0, y: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector2List(m: Init<T.Vector2List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeVector2(e, w); w.ldelim(); }
}

export function decodeVector2List(r: Reader, into?: T.Vector2List): T.Vector2List {
  const m: T.Vector2List = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeVector2(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector3(m: Init<T.Vector3>, w: Writer): void {
  if (m.x != null) w.uint32(9).double(m.x);
  if (m.y != null) w.uint32(17).double(m.y);
  if (m.z != null) w.uint32(25).double(m.z);
}

export function decodeVector3(r: Reader, into?: T.Vector3): T.Vector3 {
  const m: T.Vector3 = into ?? { x: 0, y: 0, z: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      case 25: m.z = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector3List(m: Init<T.Vector3List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeVector3(e, w); w.ldelim(); }
}

export function decodeVector3List(r: Reader, into?: T.Vector3List): T.Vector3List {
  const m: T.Vector3List = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeVector3(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector4(m: Init<T.Vector4>, w: Writer): void {
  if (m.x != null) w.uint32(9).double(m.x);
  if (m.y != null) w.uint32(17).double(m.y);
  if (m.z != null) w.uint32(25).double(m.z);
  if (m.w != null) w.uint32(33).double(m.w);
}

export function decodeVector4(r: Reader, into?: T.Vector4): T.Vector4 {
  const m: T.Vector4 = into ?? { x: 0, y: 0, z: 0, w: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      case 25: m.z = r.double(); break;
      case 33: m.w = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector4List(m: Init<T.Vector4List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeVector4(e, w); w.ldelim(); }
}

export function decodeVector4List(r: Reader, into?: T.Vector4List): T.Vector4List {
  const m: T.Vector4List = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeVector4(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector8(m: Init<T.Vector8>, w: Writer): void {
  if (m.v0 != null) w.uint32(9).double(m.v0);
  if (m.v1 != null) w.uint32(17).double(m.v1);
  if (m.v2 != null) w.uint32(25).double(m.v2);
  if (m.v3 != null) w.uint32(33).double(m.v3);
  if (m.v4 != null) w.uint32(41).double(m.v4);
  if (m.v5 != null) w.uint32(49).double(m.v5);
  if (m.v6 != null) w.uint32(57).double(m.v6);
  if (m.v7 != null) w.uint32(65).double(m.v7);
}

export function decodeVector8(r: Reader, into?: T.Vector8): T.Vector8 {
  const m: T.Vector8 = into ?? { v0: 0, v1: 0, v2: 0, v3: 0, v4: 0, v5: 0, v6: 0, v7: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.v0 = r.double(); break;
      case 17: m.v1 = r.double(); break;
      case 25: m.v2 = r.double(); break;
      case 33: m.v3 = r.double(); break;
      case 41: m.v4 = r.double(); break;
      case 49: m.v5 = r.double(); break;
      case 57: m.v6 = r.double(); break;
      case 65: m.v7 = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeVector8List(m: Init<T.Vector8List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeVector8(e, w); w.ldelim(); }
}

export function decodeVector8List(r: Reader, into?: T.Vector8List): T.Vector8List {
  const m: T.Vector8List = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeVector8(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeComponent(m: Init<T.Component>, w: Writer): void {
  if (m.topic != null) writeString(w.uint32(10), m.topic);
  if (m.messageFormat != null) writeString(w.uint32(18), m.messageFormat);
  if (m.ioType != null) w.uint32(24).int32(m.ioType);
  if (m.deviceId != null) writeString(w.uint32(34), m.deviceId);
  if (m.tags != null) for (const e of m.tags) writeString(w.uint32(42), e);
  if (m.description != null) writeString(w.uint32(50), m.description);
  if (m.id != null) writeString(w.uint32(58), m.id);
  if (m.name != null) writeString(w.uint32(66), m.name);
  if (m.notifyConditionIds != null) for (const e of m.notifyConditionIds) writeString(w.uint32(74), e);
}

export function decodeComponent(r: Reader, into?: T.Component): T.Component {
  const m: T.Component = into ?? { topic: '', messageFormat: '', ioType: 0, deviceId: '', tags: [], description: '', id: '', name: '', notifyConditionIds: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.stringVerify(); break;
      case 18: m.messageFormat = r.stringVerify(); break;
      case 24: m.ioType = r.int32() as T.ComponentIOType; break;
      case 34: m.deviceId = r.stringVerify(); break;
      case 42: m.tags.push(r.stringVerify()); break;
      case 50: m.description = r.stringVerify(); break;
      case 58: m.id = r.stringVerify(); break;
      case 66: m.name = r.stringVerify(); break;
      case 74: m.notifyConditionIds.push(r.stringVerify()); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeComponentList(m: Init<T.ComponentList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeComponent(e, w); w.ldelim(); }
}

export function decodeComponentList(r: Reader, into?: T.ComponentList): T.ComponentList {
  const m: T.ComponentList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeComponent(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeDevice(m: Init<T.Device>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.deviceType != null) w.uint32(24).int32(m.deviceType);
  if (m.components != null) for (const e of m.components) { w.uint32(34).fork(); encodeComponent(e, w); w.ldelim(); }
  if (m.clientId != null) writeString(w.uint32(42), m.clientId);
  if (m.tags != null) for (const e of m.tags) writeString(w.uint32(50), e);
  if (m.description != null) writeString(w.uint32(58), m.description);
}

export function decodeDevice(r: Reader, into?: T.Device): T.Device {
  const m: T.Device = into ?? { id: '', name: '', deviceType: 0, components: [], clientId: '', tags: [], description: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 24: m.deviceType = r.int32() as T.DeviceType; break;
      case 34: { const end = open(r); m.components.push(decodeComponent(r)); r.len = end; break; }
      case 42: m.clientId = r.stringVerify(); break;
      case 50: m.tags.push(r.stringVerify()); break;
      case 58: m.description = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeDeviceList(m: Init<T.DeviceList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeDevice(e, w); w.ldelim(); }
}

export function decodeDeviceList(r: Reader, into?: T.DeviceList): T.DeviceList {
  const m: T.DeviceList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeDevice(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicDemux(m: Init<T.TopicDemux>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.dataType != null) writeString(w.uint32(26), m.dataType);
  if (m.outputTopicFormat != null) writeString(w.uint32(34), m.outputTopicFormat);
}

export function decodeTopicDemux(r: Reader, into?: T.TopicDemux): T.TopicDemux {
  const m: T.TopicDemux = into ?? { id: '', name: '', dataType: '', outputTopicFormat: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: m.dataType = r.stringVerify(); break;
      case 34: m.outputTopicFormat = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicDemuxList(m: Init<T.TopicDemuxList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTopicDemux(e, w); w.ldelim(); }
}

export function decodeTopicDemuxList(r: Reader, into?: T.TopicDemuxList): T.TopicDemuxList {
  const m: T.TopicDemuxList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTopicDemux(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicMux(m: Init<T.TopicMux>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.dataType != null) writeString(w.uint32(26), m.dataType);
  if (m.topicSelector != null) writeString(w.uint32(34), m.topicSelector);
  if (m.identityMatchPattern != null) writeString(w.uint32(42), m.identityMatchPattern);
}

export function decodeTopicMux(r: Reader, into?: T.TopicMux): T.TopicMux {
  const m: T.TopicMux = into ?? { id: '', name: '', dataType: '', topicSelector: '', identityMatchPattern: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: m.dataType = r.stringVerify(); break;
      case 34: m.topicSelector = r.stringVerify(); break;
      case 42: m.identityMatchPattern = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicMuxList(m: Init<T.TopicMuxList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTopicMux(e, w); w.ldelim(); }
}

export function decodeTopicMuxList(r: Reader, into?: T.TopicMuxList): T.TopicMuxList {
  const m: T.TopicMuxList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTopicMux(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeClientExtension(m: Init<T.ClientExtension>, w: Writer): void {
  if (m.recordLists != null) w.uint32(8).bool(m.recordLists);
  if (m.resumeToken != null) writeString(w.uint32(18), m.resumeToken);
  if (m.resumed != null) w.uint32(24).bool(m.resumed);
  if (m.masterVersion != null) writeString(w.uint32(34), m.masterVersion);
}

export function decodeClientExtension(r: Reader, into?: T.ClientExtension): T.ClientExtension {
  const m: T.ClientExtension = into ?? { recordLists: false, resumeToken: '', resumed: false, masterVersion: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.recordLists = r.bool(); break;
      case 18: m.resumeToken = r.stringVerify(); break;
      case 24: m.resumed = r.bool(); break;
      case 34: m.masterVersion = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMasterAddress(m: Init<T.MasterAddress>, w: Writer): void {
  if (m.kind != null) w.uint32(8).int32(m.kind);
  if (m.interfaceName != null) writeString(w.uint32(18), m.interfaceName);
  if (m.url != null) writeString(w.uint32(26), m.url);
}

export function decodeMasterAddress(r: Reader, into?: T.MasterAddress): T.MasterAddress {
  const m: T.MasterAddress = into ?? { kind: 0, interfaceName: '', url: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.kind = r.int32() as T.MasterAddressKind; break;
      case 18: m.interfaceName = r.stringVerify(); break;
      case 26: m.url = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMasterStatus(m: Init<T.MasterStatus>, w: Writer): void {
  if (m.masterId != null) writeString(w.uint32(10), m.masterId);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.version != null) writeString(w.uint32(26), m.version);
  if (m.startedMs != null) w.uint32(33).double(m.startedMs);
  if (m.nowMs != null) w.uint32(41).double(m.nowMs);
  if (m.recordsIn != null) w.uint32(49).double(m.recordsIn);
  if (m.recordsOut != null) w.uint32(57).double(m.recordsOut);
  if (m.bytesIn != null) w.uint32(65).double(m.bytesIn);
  if (m.bytesOut != null) w.uint32(73).double(m.bytesOut);
  if (m.dropped != null) w.uint32(81).double(m.dropped);
  if (m.refused != null) w.uint32(89).double(m.refused);
  if (m.topics != null) w.uint32(96).int32(m.topics);
  if (m.clientsActive != null) w.uint32(104).int32(m.clientsActive);
  if (m.clientsInactive != null) w.uint32(112).int32(m.clientsInactive);
  if (m.clientsUnavailable != null) w.uint32(120).int32(m.clientsUnavailable);
  if (m.cpuPercent != null) w.uint32(133).float(m.cpuPercent);
  if (m.memoryBytes != null) w.uint32(137).double(m.memoryBytes);
  if (m.samples != null) for (const e of m.samples) { w.uint32(146).fork(); encodeStatusSample(e, w); w.ldelim(); }
  if (m.events != null) for (const e of m.events) { w.uint32(154).fork(); encodeStatusEvent(e, w); w.ldelim(); }
  if (m.problems != null) for (const e of m.problems) { w.uint32(162).fork(); encodeStatusProblem(e, w); w.ldelim(); }
  if (m.addresses != null) for (const e of m.addresses) { w.uint32(170).fork(); encodeMasterAddress(e, w); w.ldelim(); }
}

export function decodeMasterStatus(r: Reader, into?: T.MasterStatus): T.MasterStatus {
  const m: T.MasterStatus = into ?? { masterId: '', name: '', version: '', startedMs: 0, nowMs: 0, recordsIn: 0, recordsOut: 0, bytesIn: 0, bytesOut: 0, dropped: 0, refused: 0, topics: 0, clientsActive: 0, clientsInactive: 0, clientsUnavailable: 0, cpuPercent: 0, memoryBytes: 0, samples: [], events: [], problems: [], addresses: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.masterId = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: m.version = r.stringVerify(); break;
      case 33: m.startedMs = r.double(); break;
      case 41: m.nowMs = r.double(); break;
      case 49: m.recordsIn = r.double(); break;
      case 57: m.recordsOut = r.double(); break;
      case 65: m.bytesIn = r.double(); break;
      case 73: m.bytesOut = r.double(); break;
      case 81: m.dropped = r.double(); break;
      case 89: m.refused = r.double(); break;
      case 96: m.topics = r.int32(); break;
      case 104: m.clientsActive = r.int32(); break;
      case 112: m.clientsInactive = r.int32(); break;
      case 120: m.clientsUnavailable = r.int32(); break;
      case 133: m.cpuPercent = r.float(); break;
      case 137: m.memoryBytes = r.double(); break;
      case 146: { const end = open(r); m.samples.push(decodeStatusSample(r)); r.len = end; break; }
      case 154: { const end = open(r); m.events.push(decodeStatusEvent(r)); r.len = end; break; }
      case 162: { const end = open(r); m.problems.push(decodeStatusProblem(r)); r.len = end; break; }
      case 170: { const end = open(r); m.addresses.push(decodeMasterAddress(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeMasterStatusRequest(m: Init<T.MasterStatusRequest>, w: Writer): void {
  if (m.sinceMs != null) w.uint32(9).double(m.sinceMs);
}

export function decodeMasterStatusRequest(r: Reader, into?: T.MasterStatusRequest): T.MasterStatusRequest {
  const m: T.MasterStatusRequest = into ?? { sinceMs: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.sinceMs = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeStatusEvent(m: Init<T.StatusEvent>, w: Writer): void {
  if (m.timeMs != null) w.uint32(9).double(m.timeMs);
  if (m.kind != null) w.uint32(16).int32(m.kind);
  if (m.text != null) writeString(w.uint32(26), m.text);
  if (m.clientId != null) writeString(w.uint32(34), m.clientId);
}

export function decodeStatusEvent(r: Reader, into?: T.StatusEvent): T.StatusEvent {
  const m: T.StatusEvent = into ?? { timeMs: 0, kind: 0, text: '', clientId: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.timeMs = r.double(); break;
      case 16: m.kind = r.int32() as T.StatusEventKind; break;
      case 26: m.text = r.stringVerify(); break;
      case 34: m.clientId = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeStatusProblem(m: Init<T.StatusProblem>, w: Writer): void {
  if (m.code != null) writeString(w.uint32(10), m.code);
  if (m.severity != null) w.uint32(16).int32(m.severity);
  if (m.text != null) writeString(w.uint32(26), m.text);
  if (m.clientId != null) writeString(w.uint32(34), m.clientId);
  if (m.sinceMs != null) w.uint32(41).double(m.sinceMs);
}

export function decodeStatusProblem(r: Reader, into?: T.StatusProblem): T.StatusProblem {
  const m: T.StatusProblem = into ?? { code: '', severity: 0, text: '', clientId: '', sinceMs: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.code = r.stringVerify(); break;
      case 16: m.severity = r.int32() as T.StatusProblemSeverity; break;
      case 26: m.text = r.stringVerify(); break;
      case 34: m.clientId = r.stringVerify(); break;
      case 41: m.sinceMs = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeStatusSample(m: Init<T.StatusSample>, w: Writer): void {
  if (m.timeMs != null) w.uint32(9).double(m.timeMs);
  if (m.recordsPerSecond != null) w.uint32(21).float(m.recordsPerSecond);
}

export function decodeStatusSample(r: Reader, into?: T.StatusSample): T.StatusSample {
  const m: T.StatusSample = into ?? { timeMs: 0, recordsPerSecond: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.timeMs = r.double(); break;
      case 21: m.recordsPerSecond = r.float(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicStatistic(m: Init<T.TopicStatistic>, w: Writer): void {
  if (m.topic != null) writeString(w.uint32(10), m.topic);
  if (m.dataFormat != null) writeString(w.uint32(18), m.dataFormat);
  if (m.publisherId != null) writeString(w.uint32(26), m.publisherId);
  if (m.records != null) w.uint32(33).double(m.records);
  if (m.bytes != null) w.uint32(41).double(m.bytes);
  if (m.dropped != null) w.uint32(49).double(m.dropped);
  if (m.publishedMs != null) w.uint32(57).double(m.publishedMs);
  if (m.subscribers != null) w.uint32(64).int32(m.subscribers);
  if (m.valueBytes != null) w.uint32(72).int32(m.valueBytes);
}

export function decodeTopicStatistic(r: Reader, into?: T.TopicStatistic): T.TopicStatistic {
  const m: T.TopicStatistic = into ?? { topic: '', dataFormat: '', publisherId: '', records: 0, bytes: 0, dropped: 0, publishedMs: 0, subscribers: 0, valueBytes: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.stringVerify(); break;
      case 18: m.dataFormat = r.stringVerify(); break;
      case 26: m.publisherId = r.stringVerify(); break;
      case 33: m.records = r.double(); break;
      case 41: m.bytes = r.double(); break;
      case 49: m.dropped = r.double(); break;
      case 57: m.publishedMs = r.double(); break;
      case 64: m.subscribers = r.int32(); break;
      case 72: m.valueBytes = r.int32(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicStatistics(m: Init<T.TopicStatistics>, w: Writer): void {
  if (m.cursor != null) w.uint32(9).double(m.cursor);
  if (m.reset != null) w.uint32(16).bool(m.reset);
  if (m.elements != null) for (const e of m.elements) { w.uint32(26).fork(); encodeTopicStatistic(e, w); w.ldelim(); }
  if (m.removed != null) for (const e of m.removed) writeString(w.uint32(34), e);
  if (m.masterTimeMs != null) w.uint32(41).double(m.masterTimeMs);
}

export function decodeTopicStatistics(r: Reader, into?: T.TopicStatistics): T.TopicStatistics {
  const m: T.TopicStatistics = into ?? { cursor: 0, reset: false, elements: [], removed: [], masterTimeMs: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.cursor = r.double(); break;
      case 16: m.reset = r.bool(); break;
      case 26: { const end = open(r); m.elements.push(decodeTopicStatistic(r)); r.len = end; break; }
      case 34: m.removed.push(r.stringVerify()); break;
      case 41: m.masterTimeMs = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicStatisticsRequest(m: Init<T.TopicStatisticsRequest>, w: Writer): void {
  if (m.cursor != null) w.uint32(9).double(m.cursor);
}

export function decodeTopicStatisticsRequest(r: Reader, into?: T.TopicStatisticsRequest): T.TopicStatisticsRequest {
  const m: T.TopicStatisticsRequest = into ?? { cursor: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.cursor = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeErrorMessage(m: Init<T.ErrorMessage>, w: Writer): void {
  if (m.title != null) writeString(w.uint32(10), m.title);
  if (m.message != null) writeString(w.uint32(18), m.message);
  if (m.stack != null) writeString(w.uint32(26), m.stack);
  if (m.code != null) writeString(w.uint32(8002), m.code);
}

export function decodeErrorMessage(r: Reader, into?: T.ErrorMessage): T.ErrorMessage {
  const m: T.ErrorMessage = into ?? { title: '', message: '', stack: '', code: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.title = r.stringVerify(); break;
      case 18: m.message = r.stringVerify(); break;
      case 26: m.stack = r.stringVerify(); break;
      case 8002: m.code = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeErrorList(m: Init<T.ErrorList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeErrorMessage(e, w); w.ldelim(); }
}

export function decodeErrorList(r: Reader, into?: T.ErrorList): T.ErrorList {
  const m: T.ErrorList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeErrorMessage(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeSuccess(m: Init<T.Success>, w: Writer): void {
  if (m.title != null) writeString(w.uint32(10), m.title);
  if (m.message != null) writeString(w.uint32(18), m.message);
}

export function decodeSuccess(r: Reader, into?: T.Success): T.Success {
  const m: T.Success = into ?? { title: '', message: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.title = r.stringVerify(); break;
      case 18: m.message = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeSuccessList(m: Init<T.SuccessList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeSuccess(e, w); w.ldelim(); }
}

export function decodeSuccessList(r: Reader, into?: T.SuccessList): T.SuccessList {
  const m: T.SuccessList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeSuccess(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeLockstepProcessingReply(m: Init<T.LockstepProcessingReply>, w: Writer): void {
  if (m.processingModuleIds != null) for (const e of m.processingModuleIds) writeString(w.uint32(10), e);
  if (m.records != null) for (const e of m.records) { w.uint32(18).fork(); encodeTopicDataRecord(e, w); w.ldelim(); }
}

export function decodeLockstepProcessingReply(r: Reader, into?: T.LockstepProcessingReply): T.LockstepProcessingReply {
  const m: T.LockstepProcessingReply = into ?? { processingModuleIds: [], records: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processingModuleIds.push(r.stringVerify()); break;
      case 18: { const end = open(r); m.records.push(decodeTopicDataRecord(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeLockstepProcessingRequest(m: Init<T.LockstepProcessingRequest>, w: Writer): void {
  if (m.processingModuleIds != null) for (const e of m.processingModuleIds) writeString(w.uint32(10), e);
  if (m.records != null) for (const e of m.records) { w.uint32(18).fork(); encodeTopicDataRecord(e, w); w.ldelim(); }
  if (m.deltaTimeMs != null) w.uint32(24).int32(m.deltaTimeMs);
}

export function decodeLockstepProcessingRequest(r: Reader, into?: T.LockstepProcessingRequest): T.LockstepProcessingRequest {
  const m: T.LockstepProcessingRequest = into ?? { processingModuleIds: [], records: [], deltaTimeMs: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processingModuleIds.push(r.stringVerify()); break;
      case 18: { const end = open(r); m.records.push(decodeTopicDataRecord(r)); r.len = end; break; }
      case 24: m.deltaTimeMs = r.int32(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeModuleIO(m: Init<T.ModuleIO>, w: Writer): void {
  if (m.internalName != null) writeString(w.uint32(10), m.internalName);
  if (m.messageFormat != null) writeString(w.uint32(18), m.messageFormat);
  if (m.isRecordList != null) w.uint32(24).bool(m.isRecordList);
}

export function decodeModuleIO(r: Reader, into?: T.ModuleIO): T.ModuleIO {
  const m: T.ModuleIO = into ?? { internalName: '', messageFormat: '', isRecordList: false };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.internalName = r.stringVerify(); break;
      case 18: m.messageFormat = r.stringVerify(); break;
      case 24: m.isRecordList = r.bool(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingMode(m: Init<T.ProcessingMode>, w: Writer): void {
  if (m.frequency != null) { w.uint32(10).fork(); encodeProcessingModeFrequency(m.frequency, w); w.ldelim(); }
  if (m.lockstep != null) { w.uint32(18).fork(); encodeProcessingModeLockstep(m.lockstep, w); w.ldelim(); }
  if (m.triggerOnInput != null) { w.uint32(26).fork(); encodeProcessingModeTriggerOnInput(m.triggerOnInput, w); w.ldelim(); }
  if (m.free != null) { w.uint32(34).fork(); encodeProcessingModeFree(m.free, w); w.ldelim(); }
}

const ProcessingMode_mode = ['frequency', 'lockstep', 'triggerOnInput', 'free'] as const;
export function decodeProcessingMode(r: Reader, into?: T.ProcessingMode): T.ProcessingMode {
  const m: T.ProcessingMode = into ?? {};
  let mode = into && setMember(into, ProcessingMode_mode);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: mode = only(m, mode, 'frequency'); { const end = open(r); m.frequency = decodeProcessingModeFrequency(r, m.frequency); r.len = end; break; }
      case 18: mode = only(m, mode, 'lockstep'); { const end = open(r); m.lockstep = decodeProcessingModeLockstep(r, m.lockstep); r.len = end; break; }
      case 26: mode = only(m, mode, 'triggerOnInput'); { const end = open(r); m.triggerOnInput = decodeProcessingModeTriggerOnInput(r, m.triggerOnInput); r.len = end; break; }
      case 34: mode = only(m, mode, 'free'); { const end = open(r); m.free = decodeProcessingModeFree(r, m.free); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeFree(_m: Init<T.ProcessingModeFree>, _w: Writer): void {
}

export function decodeProcessingModeFree(r: Reader, into?: T.ProcessingModeFree): T.ProcessingModeFree {
  const m: T.ProcessingModeFree = into ?? {};
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeFrequency(m: Init<T.ProcessingModeFrequency>, w: Writer): void {
  if (m.hertz != null) w.uint32(8).int32(m.hertz);
}

export function decodeProcessingModeFrequency(r: Reader, into?: T.ProcessingModeFrequency): T.ProcessingModeFrequency {
  const m: T.ProcessingModeFrequency = into ?? { hertz: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.hertz = r.int32(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeLockstep(m: Init<T.ProcessingModeLockstep>, w: Writer): void {
  if (m.processRequestEndpoint != null) writeString(w.uint32(10), m.processRequestEndpoint);
}

export function decodeProcessingModeLockstep(r: Reader, into?: T.ProcessingModeLockstep): T.ProcessingModeLockstep {
  const m: T.ProcessingModeLockstep = into ?? { processRequestEndpoint: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processRequestEndpoint = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeTriggerOnInput(m: Init<T.ProcessingModeTriggerOnInput>, w: Writer): void {
  if (m.minDelayMs != null) w.uint32(8).int32(m.minDelayMs);
  if (m.allInputsNeedUpdate != null) w.uint32(16).bool(m.allInputsNeedUpdate);
}

export function decodeProcessingModeTriggerOnInput(r: Reader, into?: T.ProcessingModeTriggerOnInput): T.ProcessingModeTriggerOnInput {
  const m: T.ProcessingModeTriggerOnInput = into ?? { minDelayMs: 0, allInputsNeedUpdate: false };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.minDelayMs = r.int32(); break;
      case 16: m.allInputsNeedUpdate = r.bool(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModule(m: Init<T.ProcessingModule>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.authors != null) for (const e of m.authors) writeString(w.uint32(26), e);
  if (m.tags != null) for (const e of m.tags) writeString(w.uint32(34), e);
  if (m.description != null) writeString(w.uint32(42), m.description);
  if (m.nodeId != null) writeString(w.uint32(50), m.nodeId);
  if (m.sessionId != null) writeString(w.uint32(58), m.sessionId);
  if (m.status != null) w.uint32(64).int32(m.status);
  if (m.processingMode != null) { w.uint32(74).fork(); encodeProcessingMode(m.processingMode, w); w.ldelim(); }
  if (m.inputs != null) for (const e of m.inputs) { w.uint32(82).fork(); encodeModuleIO(e, w); w.ldelim(); }
  if (m.outputs != null) for (const e of m.outputs) { w.uint32(90).fork(); encodeModuleIO(e, w); w.ldelim(); }
  if (m.language != null && m.language !== 0) w.uint32(96).int32(m.language);
  if (m.onProcessingStringified != null) writeString(w.uint32(106), m.onProcessingStringified);
  if (m.onCreatedStringified != null) writeString(w.uint32(114), m.onCreatedStringified);
  if (m.onHaltedStringified != null) writeString(w.uint32(122), m.onHaltedStringified);
  if (m.onDestroyedStringified != null) writeString(w.uint32(130), m.onDestroyedStringified);
}

export function decodeProcessingModule(r: Reader, into?: T.ProcessingModule): T.ProcessingModule {
  const m: T.ProcessingModule = into ?? { id: '', name: '', authors: [], tags: [], description: '', nodeId: '', sessionId: '', status: 0, processingMode: undefined, inputs: [], outputs: [], language: 0, onProcessingStringified: '', onCreatedStringified: '', onHaltedStringified: '', onDestroyedStringified: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: m.authors.push(r.stringVerify()); break;
      case 34: m.tags.push(r.stringVerify()); break;
      case 42: m.description = r.stringVerify(); break;
      case 50: m.nodeId = r.stringVerify(); break;
      case 58: m.sessionId = r.stringVerify(); break;
      case 64: m.status = r.int32() as T.ProcessingModuleStatus; break;
      case 74: { const end = open(r); m.processingMode = decodeProcessingMode(r, m.processingMode); r.len = end; break; }
      case 82: { const end = open(r); m.inputs.push(decodeModuleIO(r)); r.len = end; break; }
      case 90: { const end = open(r); m.outputs.push(decodeModuleIO(r)); r.len = end; break; }
      case 96: m.language = r.int32() as T.ProcessingModuleLanguage; break;
      case 106: m.onProcessingStringified = r.stringVerify(); break;
      case 114: m.onCreatedStringified = r.stringVerify(); break;
      case 122: m.onHaltedStringified = r.stringVerify(); break;
      case 130: m.onDestroyedStringified = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModuleList(m: Init<T.ProcessingModuleList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeProcessingModule(e, w); w.ldelim(); }
}

export function decodeProcessingModuleList(r: Reader, into?: T.ProcessingModuleList): T.ProcessingModuleList {
  const m: T.ProcessingModuleList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeProcessingModule(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeServer(m: Init<T.Server>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.ipEthernet != null) writeString(w.uint32(26), m.ipEthernet);
  if (m.ipWlan != null) writeString(w.uint32(34), m.ipWlan);
  if (m.portServiceZmq != null) writeString(w.uint32(42), m.portServiceZmq);
  if (m.portServiceRest != null) writeString(w.uint32(50), m.portServiceRest);
  if (m.portTopicDataZmq != null) writeString(w.uint32(58), m.portTopicDataZmq);
  if (m.portTopicDataWs != null) writeString(w.uint32(66), m.portTopicDataWs);
  if (m.constantsJson != null) writeString(w.uint32(74), m.constantsJson);
  if (m.externalAddressServiceZmq != null) writeString(w.uint32(82), m.externalAddressServiceZmq);
  if (m.externalAddressServiceHttpJson != null) writeString(w.uint32(90), m.externalAddressServiceHttpJson);
  if (m.externalAddressServiceHttpBinary != null) writeString(w.uint32(98), m.externalAddressServiceHttpBinary);
  if (m.externalAddressTopicDataZmq != null) writeString(w.uint32(106), m.externalAddressTopicDataZmq);
  if (m.externalAddressTopicDataWs != null) writeString(w.uint32(114), m.externalAddressTopicDataWs);
}

export function decodeServer(r: Reader, into?: T.Server): T.Server {
  const m: T.Server = into ?? { id: '', name: '', ipEthernet: '', ipWlan: '', portServiceZmq: '', portServiceRest: '', portTopicDataZmq: '', portTopicDataWs: '', constantsJson: '', externalAddressServiceZmq: '', externalAddressServiceHttpJson: '', externalAddressServiceHttpBinary: '', externalAddressTopicDataZmq: '', externalAddressTopicDataWs: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: m.ipEthernet = r.stringVerify(); break;
      case 34: m.ipWlan = r.stringVerify(); break;
      case 42: m.portServiceZmq = r.stringVerify(); break;
      case 50: m.portServiceRest = r.stringVerify(); break;
      case 58: m.portTopicDataZmq = r.stringVerify(); break;
      case 66: m.portTopicDataWs = r.stringVerify(); break;
      case 74: m.constantsJson = r.stringVerify(); break;
      case 82: m.externalAddressServiceZmq = r.stringVerify(); break;
      case 90: m.externalAddressServiceHttpJson = r.stringVerify(); break;
      case 98: m.externalAddressServiceHttpBinary = r.stringVerify(); break;
      case 106: m.externalAddressTopicDataZmq = r.stringVerify(); break;
      case 114: m.externalAddressTopicDataWs = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeService(m: Init<T.Service>, w: Writer): void {
  if (m.topic != null) writeString(w.uint32(10), m.topic);
  if (m.requestMessageFormat != null) writeString(w.uint32(18), m.requestMessageFormat);
  if (m.responseMessageFormat != null) writeString(w.uint32(26), m.responseMessageFormat);
  if (m.tags != null) for (const e of m.tags) writeString(w.uint32(34), e);
  if (m.description != null) writeString(w.uint32(42), m.description);
}

export function decodeService(r: Reader, into?: T.Service): T.Service {
  const m: T.Service = into ?? { topic: '', requestMessageFormat: '', responseMessageFormat: '', tags: [], description: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.stringVerify(); break;
      case 18: m.requestMessageFormat = r.stringVerify(); break;
      case 26: m.responseMessageFormat = r.stringVerify(); break;
      case 34: m.tags.push(r.stringVerify()); break;
      case 42: m.description = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeServiceList(m: Init<T.ServiceList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeService(e, w); w.ldelim(); }
}

export function decodeServiceList(r: Reader, into?: T.ServiceList): T.ServiceList {
  const m: T.ServiceList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeService(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeServiceReply(m: Init<T.ServiceReply>, w: Writer): void {
  if (m.success != null) { w.uint32(10).fork(); encodeSuccess(m.success, w); w.ldelim(); }
  if (m.error != null) { w.uint32(18).fork(); encodeErrorMessage(m.error, w); w.ldelim(); }
  if (m.client != null) { w.uint32(26).fork(); encodeClient(m.client, w); w.ldelim(); }
  if (m.device != null) { w.uint32(34).fork(); encodeDevice(m.device, w); w.ldelim(); }
  if (m.server != null) { w.uint32(42).fork(); encodeServer(m.server, w); w.ldelim(); }
  if (m.session != null) { w.uint32(50).fork(); encodeSession(m.session, w); w.ldelim(); }
  if (m.sessionList != null) { w.uint32(58).fork(); encodeSessionList(m.sessionList, w); w.ldelim(); }
  if (m.processingModule != null) { w.uint32(66).fork(); encodeProcessingModule(m.processingModule, w); w.ldelim(); }
  if (m.processingModuleList != null) { w.uint32(74).fork(); encodeProcessingModuleList(m.processingModuleList, w); w.ldelim(); }
  if (m.stringList != null) { w.uint32(82).fork(); encodeStringList(m.stringList, w); w.ldelim(); }
  if (m.topicMux != null) { w.uint32(90).fork(); encodeTopicMux(m.topicMux, w); w.ldelim(); }
  if (m.topicMuxList != null) { w.uint32(98).fork(); encodeTopicMuxList(m.topicMuxList, w); w.ldelim(); }
  if (m.topicDemux != null) { w.uint32(106).fork(); encodeTopicDemux(m.topicDemux, w); w.ldelim(); }
  if (m.topicDemuxList != null) { w.uint32(114).fork(); encodeTopicDemuxList(m.topicDemuxList, w); w.ldelim(); }
  if (m.clientList != null) { w.uint32(122).fork(); encodeClientList(m.clientList, w); w.ldelim(); }
  if (m.deviceList != null) { w.uint32(130).fork(); encodeDeviceList(m.deviceList, w); w.ldelim(); }
  if (m.service != null) { w.uint32(138).fork(); encodeService(m.service, w); w.ldelim(); }
  if (m.serviceList != null) { w.uint32(146).fork(); encodeServiceList(m.serviceList, w); w.ldelim(); }
  if (m.lockstepProcessingReply != null) { w.uint32(154).fork(); encodeLockstepProcessingReply(m.lockstepProcessingReply, w); w.ldelim(); }
  if (m.component != null) { w.uint32(162).fork(); encodeComponent(m.component, w); w.ldelim(); }
  if (m.componentList != null) { w.uint32(170).fork(); encodeComponentList(m.componentList, w); w.ldelim(); }
  if (m.notifyCondition != null) { w.uint32(178).fork(); encodeNotifyCondition(m.notifyCondition, w); w.ldelim(); }
  if (m.topicStatistics != null) { w.uint32(8002).fork(); encodeTopicStatistics(m.topicStatistics, w); w.ldelim(); }
  if (m.masterStatus != null) { w.uint32(8010).fork(); encodeMasterStatus(m.masterStatus, w); w.ldelim(); }
}

const ServiceReply_type = ['success', 'error', 'client', 'device', 'server', 'session', 'sessionList', 'processingModule', 'processingModuleList', 'stringList', 'topicMux', 'topicMuxList', 'topicDemux', 'topicDemuxList', 'clientList', 'deviceList', 'service', 'serviceList', 'lockstepProcessingReply', 'component', 'componentList', 'notifyCondition', 'topicStatistics', 'masterStatus'] as const;
export function decodeServiceReply(r: Reader, into?: T.ServiceReply): T.ServiceReply {
  const m: T.ServiceReply = into ?? {};
  let type = into && setMember(into, ServiceReply_type);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: type = only(m, type, 'success'); { const end = open(r); m.success = decodeSuccess(r, m.success); r.len = end; break; }
      case 18: type = only(m, type, 'error'); { const end = open(r); m.error = decodeErrorMessage(r, m.error); r.len = end; break; }
      case 26: type = only(m, type, 'client'); { const end = open(r); m.client = decodeClient(r, m.client); r.len = end; break; }
      case 34: type = only(m, type, 'device'); { const end = open(r); m.device = decodeDevice(r, m.device); r.len = end; break; }
      case 42: type = only(m, type, 'server'); { const end = open(r); m.server = decodeServer(r, m.server); r.len = end; break; }
      case 50: type = only(m, type, 'session'); { const end = open(r); m.session = decodeSession(r, m.session); r.len = end; break; }
      case 58: type = only(m, type, 'sessionList'); { const end = open(r); m.sessionList = decodeSessionList(r, m.sessionList); r.len = end; break; }
      case 66: type = only(m, type, 'processingModule'); { const end = open(r); m.processingModule = decodeProcessingModule(r, m.processingModule); r.len = end; break; }
      case 74: type = only(m, type, 'processingModuleList'); { const end = open(r); m.processingModuleList = decodeProcessingModuleList(r, m.processingModuleList); r.len = end; break; }
      case 82: type = only(m, type, 'stringList'); { const end = open(r); m.stringList = decodeStringList(r, m.stringList); r.len = end; break; }
      case 90: type = only(m, type, 'topicMux'); { const end = open(r); m.topicMux = decodeTopicMux(r, m.topicMux); r.len = end; break; }
      case 98: type = only(m, type, 'topicMuxList'); { const end = open(r); m.topicMuxList = decodeTopicMuxList(r, m.topicMuxList); r.len = end; break; }
      case 106: type = only(m, type, 'topicDemux'); { const end = open(r); m.topicDemux = decodeTopicDemux(r, m.topicDemux); r.len = end; break; }
      case 114: type = only(m, type, 'topicDemuxList'); { const end = open(r); m.topicDemuxList = decodeTopicDemuxList(r, m.topicDemuxList); r.len = end; break; }
      case 122: type = only(m, type, 'clientList'); { const end = open(r); m.clientList = decodeClientList(r, m.clientList); r.len = end; break; }
      case 130: type = only(m, type, 'deviceList'); { const end = open(r); m.deviceList = decodeDeviceList(r, m.deviceList); r.len = end; break; }
      case 138: type = only(m, type, 'service'); { const end = open(r); m.service = decodeService(r, m.service); r.len = end; break; }
      case 146: type = only(m, type, 'serviceList'); { const end = open(r); m.serviceList = decodeServiceList(r, m.serviceList); r.len = end; break; }
      case 154: type = only(m, type, 'lockstepProcessingReply'); { const end = open(r); m.lockstepProcessingReply = decodeLockstepProcessingReply(r, m.lockstepProcessingReply); r.len = end; break; }
      case 162: type = only(m, type, 'component'); { const end = open(r); m.component = decodeComponent(r, m.component); r.len = end; break; }
      case 170: type = only(m, type, 'componentList'); { const end = open(r); m.componentList = decodeComponentList(r, m.componentList); r.len = end; break; }
      case 178: type = only(m, type, 'notifyCondition'); { const end = open(r); m.notifyCondition = decodeNotifyCondition(r, m.notifyCondition); r.len = end; break; }
      case 8002: type = only(m, type, 'topicStatistics'); { const end = open(r); m.topicStatistics = decodeTopicStatistics(r, m.topicStatistics); r.len = end; break; }
      case 8010: type = only(m, type, 'masterStatus'); { const end = open(r); m.masterStatus = decodeMasterStatus(r, m.masterStatus); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeServiceRequest(m: Init<T.ServiceRequest>, w: Writer): void {
  if (m.topic != null) writeString(w.uint32(10), m.topic);
  if (m.client != null) { w.uint32(18).fork(); encodeClient(m.client, w); w.ldelim(); }
  if (m.device != null) { w.uint32(26).fork(); encodeDevice(m.device, w); w.ldelim(); }
  if (m.topicSubscription != null) { w.uint32(34).fork(); encodeTopicSubscription(m.topicSubscription, w); w.ldelim(); }
  if (m.session != null) { w.uint32(42).fork(); encodeSession(m.session, w); w.ldelim(); }
  if (m.sessionList != null) { w.uint32(50).fork(); encodeSessionList(m.sessionList, w); w.ldelim(); }
  if (m.processingModule != null) { w.uint32(58).fork(); encodeProcessingModule(m.processingModule, w); w.ldelim(); }
  if (m.processingModuleList != null) { w.uint32(66).fork(); encodeProcessingModuleList(m.processingModuleList, w); w.ldelim(); }
  if (m.topicMux != null) { w.uint32(74).fork(); encodeTopicMux(m.topicMux, w); w.ldelim(); }
  if (m.topicMuxList != null) { w.uint32(82).fork(); encodeTopicMuxList(m.topicMuxList, w); w.ldelim(); }
  if (m.topicDemux != null) { w.uint32(90).fork(); encodeTopicDemux(m.topicDemux, w); w.ldelim(); }
  if (m.topicDemuxList != null) { w.uint32(98).fork(); encodeTopicDemuxList(m.topicDemuxList, w); w.ldelim(); }
  if (m.clientList != null) { w.uint32(106).fork(); encodeClientList(m.clientList, w); w.ldelim(); }
  if (m.deviceList != null) { w.uint32(114).fork(); encodeDeviceList(m.deviceList, w); w.ldelim(); }
  if (m.lockstepProcessingRequest != null) { w.uint32(122).fork(); encodeLockstepProcessingRequest(m.lockstepProcessingRequest, w); w.ldelim(); }
  if (m.component != null) { w.uint32(130).fork(); encodeComponent(m.component, w); w.ldelim(); }
  if (m.componentList != null) { w.uint32(138).fork(); encodeComponentList(m.componentList, w); w.ldelim(); }
  if (m.notifyCondition != null) { w.uint32(146).fork(); encodeNotifyCondition(m.notifyCondition, w); w.ldelim(); }
  if (m.topicStatisticsRequest != null) { w.uint32(8002).fork(); encodeTopicStatisticsRequest(m.topicStatisticsRequest, w); w.ldelim(); }
  if (m.masterStatusRequest != null) { w.uint32(8010).fork(); encodeMasterStatusRequest(m.masterStatusRequest, w); w.ldelim(); }
}

const ServiceRequest_type = ['client', 'device', 'topicSubscription', 'session', 'sessionList', 'processingModule', 'processingModuleList', 'topicMux', 'topicMuxList', 'topicDemux', 'topicDemuxList', 'clientList', 'deviceList', 'lockstepProcessingRequest', 'component', 'componentList', 'notifyCondition', 'topicStatisticsRequest', 'masterStatusRequest'] as const;
export function decodeServiceRequest(r: Reader, into?: T.ServiceRequest): T.ServiceRequest {
  const m: T.ServiceRequest = into ?? { topic: '' };
  let type = into && setMember(into, ServiceRequest_type);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.stringVerify(); break;
      case 18: type = only(m, type, 'client'); { const end = open(r); m.client = decodeClient(r, m.client); r.len = end; break; }
      case 26: type = only(m, type, 'device'); { const end = open(r); m.device = decodeDevice(r, m.device); r.len = end; break; }
      case 34: type = only(m, type, 'topicSubscription'); { const end = open(r); m.topicSubscription = decodeTopicSubscription(r, m.topicSubscription); r.len = end; break; }
      case 42: type = only(m, type, 'session'); { const end = open(r); m.session = decodeSession(r, m.session); r.len = end; break; }
      case 50: type = only(m, type, 'sessionList'); { const end = open(r); m.sessionList = decodeSessionList(r, m.sessionList); r.len = end; break; }
      case 58: type = only(m, type, 'processingModule'); { const end = open(r); m.processingModule = decodeProcessingModule(r, m.processingModule); r.len = end; break; }
      case 66: type = only(m, type, 'processingModuleList'); { const end = open(r); m.processingModuleList = decodeProcessingModuleList(r, m.processingModuleList); r.len = end; break; }
      case 74: type = only(m, type, 'topicMux'); { const end = open(r); m.topicMux = decodeTopicMux(r, m.topicMux); r.len = end; break; }
      case 82: type = only(m, type, 'topicMuxList'); { const end = open(r); m.topicMuxList = decodeTopicMuxList(r, m.topicMuxList); r.len = end; break; }
      case 90: type = only(m, type, 'topicDemux'); { const end = open(r); m.topicDemux = decodeTopicDemux(r, m.topicDemux); r.len = end; break; }
      case 98: type = only(m, type, 'topicDemuxList'); { const end = open(r); m.topicDemuxList = decodeTopicDemuxList(r, m.topicDemuxList); r.len = end; break; }
      case 106: type = only(m, type, 'clientList'); { const end = open(r); m.clientList = decodeClientList(r, m.clientList); r.len = end; break; }
      case 114: type = only(m, type, 'deviceList'); { const end = open(r); m.deviceList = decodeDeviceList(r, m.deviceList); r.len = end; break; }
      case 122: type = only(m, type, 'lockstepProcessingRequest'); { const end = open(r); m.lockstepProcessingRequest = decodeLockstepProcessingRequest(r, m.lockstepProcessingRequest); r.len = end; break; }
      case 130: type = only(m, type, 'component'); { const end = open(r); m.component = decodeComponent(r, m.component); r.len = end; break; }
      case 138: type = only(m, type, 'componentList'); { const end = open(r); m.componentList = decodeComponentList(r, m.componentList); r.len = end; break; }
      case 146: type = only(m, type, 'notifyCondition'); { const end = open(r); m.notifyCondition = decodeNotifyCondition(r, m.notifyCondition); r.len = end; break; }
      case 8002: type = only(m, type, 'topicStatisticsRequest'); { const end = open(r); m.topicStatisticsRequest = decodeTopicStatisticsRequest(r, m.topicStatisticsRequest); r.len = end; break; }
      case 8010: type = only(m, type, 'masterStatusRequest'); { const end = open(r); m.masterStatusRequest = decodeMasterStatusRequest(r, m.masterStatusRequest); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicSubscription(m: Init<T.TopicSubscription>, w: Writer): void {
  if (m.clientId != null) writeString(w.uint32(10), m.clientId);
  if (m.subscribeTopics != null) for (const e of m.subscribeTopics) writeString(w.uint32(18), e);
  if (m.unsubscribeTopics != null) for (const e of m.unsubscribeTopics) writeString(w.uint32(26), e);
  if (m.subscribeTopicRegexp != null) for (const e of m.subscribeTopicRegexp) writeString(w.uint32(34), e);
  if (m.unsubscribeTopicRegexp != null) for (const e of m.unsubscribeTopicRegexp) writeString(w.uint32(42), e);
  if (m.subscribeComponents != null) for (const e of m.subscribeComponents) { w.uint32(50).fork(); encodeComponent(e, w); w.ldelim(); }
  if (m.unsubscribeComponents != null) for (const e of m.unsubscribeComponents) { w.uint32(58).fork(); encodeComponent(e, w); w.ldelim(); }
  if (m.maxRateHz != null) w.uint32(8001).double(m.maxRateHz);
}

export function decodeTopicSubscription(r: Reader, into?: T.TopicSubscription): T.TopicSubscription {
  const m: T.TopicSubscription = into ?? { clientId: '', subscribeTopics: [], unsubscribeTopics: [], subscribeTopicRegexp: [], unsubscribeTopicRegexp: [], subscribeComponents: [], unsubscribeComponents: [], maxRateHz: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.stringVerify(); break;
      case 18: m.subscribeTopics.push(r.stringVerify()); break;
      case 26: m.unsubscribeTopics.push(r.stringVerify()); break;
      case 34: m.subscribeTopicRegexp.push(r.stringVerify()); break;
      case 42: m.unsubscribeTopicRegexp.push(r.stringVerify()); break;
      case 50: { const end = open(r); m.subscribeComponents.push(decodeComponent(r)); r.len = end; break; }
      case 58: { const end = open(r); m.unsubscribeComponents.push(decodeComponent(r)); r.len = end; break; }
      case 8001: m.maxRateHz = r.double(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeIOMapping(m: Init<T.IOMapping>, w: Writer): void {
  if (m.processingModuleId != null) writeString(w.uint32(10), m.processingModuleId);
  if (m.inputMappings != null) for (const e of m.inputMappings) { w.uint32(18).fork(); encodeTopicInputMapping(e, w); w.ldelim(); }
  if (m.outputMappings != null) for (const e of m.outputMappings) { w.uint32(26).fork(); encodeTopicOutputMapping(e, w); w.ldelim(); }
  if (m.processingModuleName != null) writeString(w.uint32(34), m.processingModuleName);
}

export function decodeIOMapping(r: Reader, into?: T.IOMapping): T.IOMapping {
  const m: T.IOMapping = into ?? { processingModuleId: '', inputMappings: [], outputMappings: [], processingModuleName: '' };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processingModuleId = r.stringVerify(); break;
      case 18: { const end = open(r); m.inputMappings.push(decodeTopicInputMapping(r)); r.len = end; break; }
      case 26: { const end = open(r); m.outputMappings.push(decodeTopicOutputMapping(r)); r.len = end; break; }
      case 34: m.processingModuleName = r.stringVerify(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeIOMappingList(m: Init<T.IOMappingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeIOMapping(e, w); w.ldelim(); }
}

export function decodeIOMappingList(r: Reader, into?: T.IOMappingList): T.IOMappingList {
  const m: T.IOMappingList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeIOMapping(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeSession(m: Init<T.Session>, w: Writer): void {
  if (m.id != null) writeString(w.uint32(10), m.id);
  if (m.name != null) writeString(w.uint32(18), m.name);
  if (m.processingModules != null) for (const e of m.processingModules) { w.uint32(26).fork(); encodeProcessingModule(e, w); w.ldelim(); }
  if (m.ioMappings != null) for (const e of m.ioMappings) { w.uint32(34).fork(); encodeIOMapping(e, w); w.ldelim(); }
  if (m.tags != null) for (const e of m.tags) writeString(w.uint32(42), e);
  if (m.description != null) writeString(w.uint32(50), m.description);
  if (m.authors != null) for (const e of m.authors) writeString(w.uint32(58), e);
  if (m.status != null) w.uint32(64).int32(m.status);
  if (m.editable != null) w.uint32(72).bool(m.editable);
}

export function decodeSession(r: Reader, into?: T.Session): T.Session {
  const m: T.Session = into ?? { id: '', name: '', processingModules: [], ioMappings: [], tags: [], description: '', authors: [], status: 0, editable: false };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.stringVerify(); break;
      case 18: m.name = r.stringVerify(); break;
      case 26: { const end = open(r); m.processingModules.push(decodeProcessingModule(r)); r.len = end; break; }
      case 34: { const end = open(r); m.ioMappings.push(decodeIOMapping(r)); r.len = end; break; }
      case 42: m.tags.push(r.stringVerify()); break;
      case 50: m.description = r.stringVerify(); break;
      case 58: m.authors.push(r.stringVerify()); break;
      case 64: m.status = r.int32() as T.SessionStatus; break;
      case 72: m.editable = r.bool(); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeSessionList(m: Init<T.SessionList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeSession(e, w); w.ldelim(); }
}

export function decodeSessionList(r: Reader, into?: T.SessionList): T.SessionList {
  const m: T.SessionList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeSession(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicInputMapping(m: Init<T.TopicInputMapping>, w: Writer): void {
  if (m.inputName != null) writeString(w.uint32(10), m.inputName);
  if (m.topic != null) writeString(w.uint32(18), m.topic);
  if (m.topicMux != null) { w.uint32(26).fork(); encodeTopicMux(m.topicMux, w); w.ldelim(); }
}

const TopicInputMapping_topic_source = ['topic', 'topicMux'] as const;
export function decodeTopicInputMapping(r: Reader, into?: T.TopicInputMapping): T.TopicInputMapping {
  const m: T.TopicInputMapping = into ?? { inputName: '' };
  let topic_source = into && setMember(into, TopicInputMapping_topic_source);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.inputName = r.stringVerify(); break;
      case 18: topic_source = only(m, topic_source, 'topic'); m.topic = r.stringVerify(); break;
      case 26: topic_source = only(m, topic_source, 'topicMux'); { const end = open(r); m.topicMux = decodeTopicMux(r, m.topicMux); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicInputMappingList(m: Init<T.TopicInputMappingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTopicInputMapping(e, w); w.ldelim(); }
}

export function decodeTopicInputMappingList(r: Reader, into?: T.TopicInputMappingList): T.TopicInputMappingList {
  const m: T.TopicInputMappingList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTopicInputMapping(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicOutputMapping(m: Init<T.TopicOutputMapping>, w: Writer): void {
  if (m.outputName != null) writeString(w.uint32(10), m.outputName);
  if (m.topic != null) writeString(w.uint32(18), m.topic);
  if (m.topicDemux != null) { w.uint32(26).fork(); encodeTopicDemux(m.topicDemux, w); w.ldelim(); }
}

const TopicOutputMapping_topic_destination = ['topic', 'topicDemux'] as const;
export function decodeTopicOutputMapping(r: Reader, into?: T.TopicOutputMapping): T.TopicOutputMapping {
  const m: T.TopicOutputMapping = into ?? { outputName: '' };
  let topic_destination = into && setMember(into, TopicOutputMapping_topic_destination);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.outputName = r.stringVerify(); break;
      case 18: topic_destination = only(m, topic_destination, 'topic'); m.topic = r.stringVerify(); break;
      case 26: topic_destination = only(m, topic_destination, 'topicDemux'); { const end = open(r); m.topicDemux = decodeTopicDemux(r, m.topicDemux); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicOutputMappingList(m: Init<T.TopicOutputMappingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTopicOutputMapping(e, w); w.ldelim(); }
}

export function decodeTopicOutputMappingList(r: Reader, into?: T.TopicOutputMappingList): T.TopicOutputMappingList {
  const m: T.TopicOutputMappingList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTopicOutputMapping(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTimestamp(m: Init<T.Timestamp>, w: Writer): void {
  if (m.seconds != null) w.uint32(8).int64(m.seconds);
  if (m.nanos != null) w.uint32(16).int32(m.nanos);
  if (m.millis != null) w.uint32(24).int64(m.millis);
}

export function decodeTimestamp(r: Reader, into?: T.Timestamp): T.Timestamp {
  const m: T.Timestamp = into ?? { seconds: 0, nanos: 0, millis: 0 };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.seconds = readInt64(r); break;
      case 16: m.nanos = r.int32(); break;
      case 24: m.millis = readInt64(r); break;
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicData(m: Init<T.TopicData>, w: Writer): void {
  if (m.topicDataRecord != null) { w.uint32(18).fork(); encodeTopicDataRecord(m.topicDataRecord, w); w.ldelim(); }
  if (m.topicDataRecordList != null) { w.uint32(26).fork(); encodeTopicDataRecordList(m.topicDataRecordList, w); w.ldelim(); }
  if (m.error != null) { w.uint32(34).fork(); encodeErrorMessage(m.error, w); w.ldelim(); }
}

const TopicData_type = ['topicDataRecord', 'topicDataRecordList', 'error'] as const;
export function decodeTopicData(r: Reader, into?: T.TopicData): T.TopicData {
  const m: T.TopicData = into ?? {};
  let type = into && setMember(into, TopicData_type);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 18: type = only(m, type, 'topicDataRecord'); { const end = open(r); m.topicDataRecord = decodeTopicDataRecord(r, m.topicDataRecord); r.len = end; break; }
      case 26: type = only(m, type, 'topicDataRecordList'); { const end = open(r); m.topicDataRecordList = decodeTopicDataRecordList(r, m.topicDataRecordList); r.len = end; break; }
      case 34: type = only(m, type, 'error'); { const end = open(r); m.error = decodeErrorMessage(r, m.error); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataRecord(m: Init<T.TopicDataRecord>, w: Writer): void {
  if (m.topic != null) writeString(w.uint32(10), m.topic);
  if (m.timestamp != null) { w.uint32(18).fork(); encodeTimestamp(m.timestamp, w); w.ldelim(); }
  if (m.double != null) w.uint32(25).double(m.double);
  if (m.bool != null) w.uint32(32).bool(m.bool);
  if (m.string != null) writeString(w.uint32(42), m.string);
  if (m.vector2 != null) { w.uint32(50).fork(); encodeVector2(m.vector2, w); w.ldelim(); }
  if (m.vector3 != null) { w.uint32(58).fork(); encodeVector3(m.vector3, w); w.ldelim(); }
  if (m.vector4 != null) { w.uint32(66).fork(); encodeVector4(m.vector4, w); w.ldelim(); }
  if (m.quaternion != null) { w.uint32(74).fork(); encodeQuaternion(m.quaternion, w); w.ldelim(); }
  if (m.matrix3x2 != null) { w.uint32(82).fork(); encodeMatrix3x2(m.matrix3x2, w); w.ldelim(); }
  if (m.matrix4x4 != null) { w.uint32(90).fork(); encodeMatrix4x4(m.matrix4x4, w); w.ldelim(); }
  if (m.color != null) { w.uint32(98).fork(); encodeColor(m.color, w); w.ldelim(); }
  if (m.touchEvent != null) { w.uint32(106).fork(); encodeTouchEventMessage(m.touchEvent, w); w.ldelim(); }
  if (m.keyEvent != null) { w.uint32(114).fork(); encodeKeyEvent(m.keyEvent, w); w.ldelim(); }
  if (m.mouseEvent != null) { w.uint32(122).fork(); encodeMouseEventMessage(m.mouseEvent, w); w.ldelim(); }
  if (m.myoEvent != null) { w.uint32(130).fork(); encodeMyoEvent(m.myoEvent, w); w.ldelim(); }
  if (m.pose2D != null) { w.uint32(138).fork(); encodePose2D(m.pose2D, w); w.ldelim(); }
  if (m.pose3D != null) { w.uint32(146).fork(); encodePose3D(m.pose3D, w); w.ldelim(); }
  if (m.object2D != null) { w.uint32(154).fork(); encodeObject2D(m.object2D, w); w.ldelim(); }
  if (m.object3D != null) { w.uint32(162).fork(); encodeObject3D(m.object3D, w); w.ldelim(); }
  if (m.object2DList != null) { w.uint32(170).fork(); encodeObject2DList(m.object2DList, w); w.ldelim(); }
  if (m.object3DList != null) { w.uint32(178).fork(); encodeObject3DList(m.object3DList, w); w.ldelim(); }
  if (m.int32 != null) w.uint32(184).int32(m.int32);
  if (m.float != null) w.uint32(197).float(m.float);
  if (m.int32List != null) { w.uint32(202).fork(); encodeInt32List(m.int32List, w); w.ldelim(); }
  if (m.floatList != null) { w.uint32(210).fork(); encodeFloatList(m.floatList, w); w.ldelim(); }
  if (m.doubleList != null) { w.uint32(218).fork(); encodeDoubleList(m.doubleList, w); w.ldelim(); }
  if (m.stringList != null) { w.uint32(226).fork(); encodeStringList(m.stringList, w); w.ldelim(); }
  if (m.boolList != null) { w.uint32(234).fork(); encodeBoolList(m.boolList, w); w.ldelim(); }
  if (m.image2D != null) { w.uint32(242).fork(); encodeImage2D(m.image2D, w); w.ldelim(); }
  if (m.image2DList != null) { w.uint32(250).fork(); encodeImage2DList(m.image2DList, w); w.ldelim(); }
  if (m.session != null) { w.uint32(258).fork(); encodeSession(m.session, w); w.ldelim(); }
  if (m.clientId != null) writeString(w.uint32(266), m.clientId);
  if (m.touchEventList != null) { w.uint32(274).fork(); encodeTouchEventList(m.touchEventList, w); w.ldelim(); }
  if (m.vector2List != null) { w.uint32(282).fork(); encodeVector2List(m.vector2List, w); w.ldelim(); }
  if (m.vector3List != null) { w.uint32(290).fork(); encodeVector3List(m.vector3List, w); w.ldelim(); }
  if (m.vector4List != null) { w.uint32(298).fork(); encodeVector4List(m.vector4List, w); w.ldelim(); }
  if (m.quaternionList != null) { w.uint32(306).fork(); encodeQuaternion(m.quaternionList, w); w.ldelim(); }
  if (m.error != null) { w.uint32(314).fork(); encodeErrorMessage(m.error, w); w.ldelim(); }
  if (m.device != null) { w.uint32(322).fork(); encodeDevice(m.device, w); w.ldelim(); }
  if (m.deviceList != null) { w.uint32(330).fork(); encodeDeviceList(m.deviceList, w); w.ldelim(); }
  if (m.component != null) { w.uint32(338).fork(); encodeComponent(m.component, w); w.ldelim(); }
  if (m.componentList != null) { w.uint32(346).fork(); encodeComponentList(m.componentList, w); w.ldelim(); }
  if (m.sessionList != null) { w.uint32(354).fork(); encodeSessionList(m.sessionList, w); w.ldelim(); }
  if (m.client != null) { w.uint32(8002).fork(); encodeClient(m.client, w); w.ldelim(); }
}

const TopicDataRecord_type = ['double', 'bool', 'string', 'vector2', 'vector3', 'vector4', 'quaternion', 'matrix3x2', 'matrix4x4', 'color', 'touchEvent', 'keyEvent', 'mouseEvent', 'myoEvent', 'pose2D', 'pose3D', 'object2D', 'object3D', 'object2DList', 'object3DList', 'int32', 'float', 'int32List', 'floatList', 'doubleList', 'stringList', 'boolList', 'image2D', 'image2DList', 'session', 'touchEventList', 'vector2List', 'vector3List', 'vector4List', 'quaternionList', 'error', 'device', 'deviceList', 'component', 'componentList', 'sessionList', 'client'] as const;
export function decodeTopicDataRecord(r: Reader, into?: T.TopicDataRecord): T.TopicDataRecord {
  const m: T.TopicDataRecord = into ?? { topic: '', timestamp: undefined, clientId: '' };
  let type = into && setMember(into, TopicDataRecord_type);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.stringVerify(); break;
      case 18: { const end = open(r); m.timestamp = decodeTimestamp(r, m.timestamp); r.len = end; break; }
      case 25: type = only(m, type, 'double'); m.double = r.double(); break;
      case 32: type = only(m, type, 'bool'); m.bool = r.bool(); break;
      case 42: type = only(m, type, 'string'); m.string = r.stringVerify(); break;
      case 50: type = only(m, type, 'vector2'); { const end = open(r); m.vector2 = decodeVector2(r, m.vector2); r.len = end; break; }
      case 58: type = only(m, type, 'vector3'); { const end = open(r); m.vector3 = decodeVector3(r, m.vector3); r.len = end; break; }
      case 66: type = only(m, type, 'vector4'); { const end = open(r); m.vector4 = decodeVector4(r, m.vector4); r.len = end; break; }
      case 74: type = only(m, type, 'quaternion'); { const end = open(r); m.quaternion = decodeQuaternion(r, m.quaternion); r.len = end; break; }
      case 82: type = only(m, type, 'matrix3x2'); { const end = open(r); m.matrix3x2 = decodeMatrix3x2(r, m.matrix3x2); r.len = end; break; }
      case 90: type = only(m, type, 'matrix4x4'); { const end = open(r); m.matrix4x4 = decodeMatrix4x4(r, m.matrix4x4); r.len = end; break; }
      case 98: type = only(m, type, 'color'); { const end = open(r); m.color = decodeColor(r, m.color); r.len = end; break; }
      case 106: type = only(m, type, 'touchEvent'); { const end = open(r); m.touchEvent = decodeTouchEventMessage(r, m.touchEvent); r.len = end; break; }
      case 114: type = only(m, type, 'keyEvent'); { const end = open(r); m.keyEvent = decodeKeyEvent(r, m.keyEvent); r.len = end; break; }
      case 122: type = only(m, type, 'mouseEvent'); { const end = open(r); m.mouseEvent = decodeMouseEventMessage(r, m.mouseEvent); r.len = end; break; }
      case 130: type = only(m, type, 'myoEvent'); { const end = open(r); m.myoEvent = decodeMyoEvent(r, m.myoEvent); r.len = end; break; }
      case 138: type = only(m, type, 'pose2D'); { const end = open(r); m.pose2D = decodePose2D(r, m.pose2D); r.len = end; break; }
      case 146: type = only(m, type, 'pose3D'); { const end = open(r); m.pose3D = decodePose3D(r, m.pose3D); r.len = end; break; }
      case 154: type = only(m, type, 'object2D'); { const end = open(r); m.object2D = decodeObject2D(r, m.object2D); r.len = end; break; }
      case 162: type = only(m, type, 'object3D'); { const end = open(r); m.object3D = decodeObject3D(r, m.object3D); r.len = end; break; }
      case 170: type = only(m, type, 'object2DList'); { const end = open(r); m.object2DList = decodeObject2DList(r, m.object2DList); r.len = end; break; }
      case 178: type = only(m, type, 'object3DList'); { const end = open(r); m.object3DList = decodeObject3DList(r, m.object3DList); r.len = end; break; }
      case 184: type = only(m, type, 'int32'); m.int32 = r.int32(); break;
      case 197: type = only(m, type, 'float'); m.float = r.float(); break;
      case 202: type = only(m, type, 'int32List'); { const end = open(r); m.int32List = decodeInt32List(r, m.int32List); r.len = end; break; }
      case 210: type = only(m, type, 'floatList'); { const end = open(r); m.floatList = decodeFloatList(r, m.floatList); r.len = end; break; }
      case 218: type = only(m, type, 'doubleList'); { const end = open(r); m.doubleList = decodeDoubleList(r, m.doubleList); r.len = end; break; }
      case 226: type = only(m, type, 'stringList'); { const end = open(r); m.stringList = decodeStringList(r, m.stringList); r.len = end; break; }
      case 234: type = only(m, type, 'boolList'); { const end = open(r); m.boolList = decodeBoolList(r, m.boolList); r.len = end; break; }
      case 242: type = only(m, type, 'image2D'); { const end = open(r); m.image2D = decodeImage2D(r, m.image2D); r.len = end; break; }
      case 250: type = only(m, type, 'image2DList'); { const end = open(r); m.image2DList = decodeImage2DList(r, m.image2DList); r.len = end; break; }
      case 258: type = only(m, type, 'session'); { const end = open(r); m.session = decodeSession(r, m.session); r.len = end; break; }
      case 266: m.clientId = r.stringVerify(); break;
      case 274: type = only(m, type, 'touchEventList'); { const end = open(r); m.touchEventList = decodeTouchEventList(r, m.touchEventList); r.len = end; break; }
      case 282: type = only(m, type, 'vector2List'); { const end = open(r); m.vector2List = decodeVector2List(r, m.vector2List); r.len = end; break; }
      case 290: type = only(m, type, 'vector3List'); { const end = open(r); m.vector3List = decodeVector3List(r, m.vector3List); r.len = end; break; }
      case 298: type = only(m, type, 'vector4List'); { const end = open(r); m.vector4List = decodeVector4List(r, m.vector4List); r.len = end; break; }
      case 306: type = only(m, type, 'quaternionList'); { const end = open(r); m.quaternionList = decodeQuaternion(r, m.quaternionList); r.len = end; break; }
      case 314: type = only(m, type, 'error'); { const end = open(r); m.error = decodeErrorMessage(r, m.error); r.len = end; break; }
      case 322: type = only(m, type, 'device'); { const end = open(r); m.device = decodeDevice(r, m.device); r.len = end; break; }
      case 330: type = only(m, type, 'deviceList'); { const end = open(r); m.deviceList = decodeDeviceList(r, m.deviceList); r.len = end; break; }
      case 338: type = only(m, type, 'component'); { const end = open(r); m.component = decodeComponent(r, m.component); r.len = end; break; }
      case 346: type = only(m, type, 'componentList'); { const end = open(r); m.componentList = decodeComponentList(r, m.componentList); r.len = end; break; }
      case 354: type = only(m, type, 'sessionList'); { const end = open(r); m.sessionList = decodeSessionList(r, m.sessionList); r.len = end; break; }
      case 8002: type = only(m, type, 'client'); { const end = open(r); m.client = decodeClient(r, m.client); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataRecordList(m: Init<T.TopicDataRecordList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTopicDataRecord(e, w); w.ldelim(); }
}

export function decodeTopicDataRecordList(r: Reader, into?: T.TopicDataRecordList): T.TopicDataRecordList {
  const m: T.TopicDataRecordList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTopicDataRecord(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataSource(m: Init<T.TopicDataSource>, w: Writer): void {
  if (m.topic != null) writeString(w.uint32(10), m.topic);
  if (m.regex != null) writeString(w.uint32(18), m.regex);
  if (m.component != null) { w.uint32(26).fork(); encodeComponent(m.component, w); w.ldelim(); }
  if (m.staticRecord != null) { w.uint32(34).fork(); encodeTopicDataRecord(m.staticRecord, w); w.ldelim(); }
}

const TopicDataSource_type = ['topic', 'regex', 'component', 'staticRecord'] as const;
export function decodeTopicDataSource(r: Reader, into?: T.TopicDataSource): T.TopicDataSource {
  const m: T.TopicDataSource = into ?? {};
  let type = into && setMember(into, TopicDataSource_type);
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: type = only(m, type, 'topic'); m.topic = r.stringVerify(); break;
      case 18: type = only(m, type, 'regex'); m.regex = r.stringVerify(); break;
      case 26: type = only(m, type, 'component'); { const end = open(r); m.component = decodeComponent(r, m.component); r.len = end; break; }
      case 34: type = only(m, type, 'staticRecord'); { const end = open(r); m.staticRecord = decodeTopicDataRecord(r, m.staticRecord); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataSourceList(m: Init<T.TopicDataSourceList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { w.uint32(10).fork(); encodeTopicDataSource(e, w); w.ldelim(); }
}

export function decodeTopicDataSourceList(r: Reader, into?: T.TopicDataSourceList): T.TopicDataSourceList {
  const m: T.TopicDataSourceList = into ?? { elements: [] };
  while (r.pos < r.len) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = open(r); m.elements.push(decodeTopicDataSource(r)); r.len = end; break; }
      default: skip(r, tag);
    }
  }
  return m;
}

/** Both directions of every message by its full name. */
export const CODECS: {
  readonly [K in keyof T.MessageTypes]: {
    readonly encode: (m: Init<T.MessageTypes[K]>, w: Writer) => void;
    readonly decode: (r: Reader) => T.MessageTypes[K];
  };
} = {
  'ubii.clients.Client': { encode: encodeClient, decode: decodeClient },
  'ubii.clients.ClientList': { encode: encodeClientList, decode: decodeClientList },
  'ubii.conditions.NotifyCondition': { encode: encodeNotifyCondition, decode: decodeNotifyCondition },
  'ubii.dataStructure.BoolList': { encode: encodeBoolList, decode: decodeBoolList },
  'ubii.dataStructure.Color': { encode: encodeColor, decode: decodeColor },
  'ubii.dataStructure.DoubleList': { encode: encodeDoubleList, decode: decodeDoubleList },
  'ubii.dataStructure.FloatList': { encode: encodeFloatList, decode: decodeFloatList },
  'ubii.dataStructure.Image2D': { encode: encodeImage2D, decode: decodeImage2D },
  'ubii.dataStructure.Image2DList': { encode: encodeImage2DList, decode: decodeImage2DList },
  'ubii.dataStructure.Int32List': { encode: encodeInt32List, decode: decodeInt32List },
  'ubii.dataStructure.KeyEvent': { encode: encodeKeyEvent, decode: decodeKeyEvent },
  'ubii.dataStructure.Matrix3x2': { encode: encodeMatrix3x2, decode: decodeMatrix3x2 },
  'ubii.dataStructure.Matrix4x4': { encode: encodeMatrix4x4, decode: decodeMatrix4x4 },
  'ubii.dataStructure.MouseEvent': { encode: encodeMouseEventMessage, decode: decodeMouseEventMessage },
  'ubii.dataStructure.MyoEvent': { encode: encodeMyoEvent, decode: decodeMyoEvent },
  'ubii.dataStructure.Object2D': { encode: encodeObject2D, decode: decodeObject2D },
  'ubii.dataStructure.Object2DList': { encode: encodeObject2DList, decode: decodeObject2DList },
  'ubii.dataStructure.Object3D': { encode: encodeObject3D, decode: decodeObject3D },
  'ubii.dataStructure.Object3DList': { encode: encodeObject3DList, decode: decodeObject3DList },
  'ubii.dataStructure.Pose2D': { encode: encodePose2D, decode: decodePose2D },
  'ubii.dataStructure.Pose3D': { encode: encodePose3D, decode: decodePose3D },
  'ubii.dataStructure.Quaternion': { encode: encodeQuaternion, decode: decodeQuaternion },
  'ubii.dataStructure.QuaternionList': { encode: encodeQuaternionList, decode: decodeQuaternionList },
  'ubii.dataStructure.StringList': { encode: encodeStringList, decode: decodeStringList },
  'ubii.dataStructure.TouchEvent': { encode: encodeTouchEventMessage, decode: decodeTouchEventMessage },
  'ubii.dataStructure.TouchEventList': { encode: encodeTouchEventList, decode: decodeTouchEventList },
  'ubii.dataStructure.Vector2': { encode: encodeVector2, decode: decodeVector2 },
  'ubii.dataStructure.Vector2List': { encode: encodeVector2List, decode: decodeVector2List },
  'ubii.dataStructure.Vector3': { encode: encodeVector3, decode: decodeVector3 },
  'ubii.dataStructure.Vector3List': { encode: encodeVector3List, decode: decodeVector3List },
  'ubii.dataStructure.Vector4': { encode: encodeVector4, decode: decodeVector4 },
  'ubii.dataStructure.Vector4List': { encode: encodeVector4List, decode: decodeVector4List },
  'ubii.dataStructure.Vector8': { encode: encodeVector8, decode: decodeVector8 },
  'ubii.dataStructure.Vector8List': { encode: encodeVector8List, decode: decodeVector8List },
  'ubii.devices.Component': { encode: encodeComponent, decode: decodeComponent },
  'ubii.devices.ComponentList': { encode: encodeComponentList, decode: decodeComponentList },
  'ubii.devices.Device': { encode: encodeDevice, decode: decodeDevice },
  'ubii.devices.DeviceList': { encode: encodeDeviceList, decode: decodeDeviceList },
  'ubii.devices.TopicDemux': { encode: encodeTopicDemux, decode: decodeTopicDemux },
  'ubii.devices.TopicDemuxList': { encode: encodeTopicDemuxList, decode: decodeTopicDemuxList },
  'ubii.devices.TopicMux': { encode: encodeTopicMux, decode: decodeTopicMux },
  'ubii.devices.TopicMuxList': { encode: encodeTopicMuxList, decode: decodeTopicMuxList },
  'ubii.extension.ClientExtension': { encode: encodeClientExtension, decode: decodeClientExtension },
  'ubii.extension.MasterAddress': { encode: encodeMasterAddress, decode: decodeMasterAddress },
  'ubii.extension.MasterStatus': { encode: encodeMasterStatus, decode: decodeMasterStatus },
  'ubii.extension.MasterStatusRequest': { encode: encodeMasterStatusRequest, decode: decodeMasterStatusRequest },
  'ubii.extension.StatusEvent': { encode: encodeStatusEvent, decode: decodeStatusEvent },
  'ubii.extension.StatusProblem': { encode: encodeStatusProblem, decode: decodeStatusProblem },
  'ubii.extension.StatusSample': { encode: encodeStatusSample, decode: decodeStatusSample },
  'ubii.extension.TopicStatistic': { encode: encodeTopicStatistic, decode: decodeTopicStatistic },
  'ubii.extension.TopicStatistics': { encode: encodeTopicStatistics, decode: decodeTopicStatistics },
  'ubii.extension.TopicStatisticsRequest': { encode: encodeTopicStatisticsRequest, decode: decodeTopicStatisticsRequest },
  'ubii.general.Error': { encode: encodeErrorMessage, decode: decodeErrorMessage },
  'ubii.general.ErrorList': { encode: encodeErrorList, decode: decodeErrorList },
  'ubii.general.Success': { encode: encodeSuccess, decode: decodeSuccess },
  'ubii.general.SuccessList': { encode: encodeSuccessList, decode: decodeSuccessList },
  'ubii.processing.LockstepProcessingReply': { encode: encodeLockstepProcessingReply, decode: decodeLockstepProcessingReply },
  'ubii.processing.LockstepProcessingRequest': { encode: encodeLockstepProcessingRequest, decode: decodeLockstepProcessingRequest },
  'ubii.processing.ModuleIO': { encode: encodeModuleIO, decode: decodeModuleIO },
  'ubii.processing.ProcessingMode': { encode: encodeProcessingMode, decode: decodeProcessingMode },
  'ubii.processing.ProcessingMode.Free': { encode: encodeProcessingModeFree, decode: decodeProcessingModeFree },
  'ubii.processing.ProcessingMode.Frequency': { encode: encodeProcessingModeFrequency, decode: decodeProcessingModeFrequency },
  'ubii.processing.ProcessingMode.Lockstep': { encode: encodeProcessingModeLockstep, decode: decodeProcessingModeLockstep },
  'ubii.processing.ProcessingMode.TriggerOnInput': { encode: encodeProcessingModeTriggerOnInput, decode: decodeProcessingModeTriggerOnInput },
  'ubii.processing.ProcessingModule': { encode: encodeProcessingModule, decode: decodeProcessingModule },
  'ubii.processing.ProcessingModuleList': { encode: encodeProcessingModuleList, decode: decodeProcessingModuleList },
  'ubii.servers.Server': { encode: encodeServer, decode: decodeServer },
  'ubii.services.Service': { encode: encodeService, decode: decodeService },
  'ubii.services.ServiceList': { encode: encodeServiceList, decode: decodeServiceList },
  'ubii.services.ServiceReply': { encode: encodeServiceReply, decode: decodeServiceReply },
  'ubii.services.ServiceRequest': { encode: encodeServiceRequest, decode: decodeServiceRequest },
  'ubii.services.request.TopicSubscription': { encode: encodeTopicSubscription, decode: decodeTopicSubscription },
  'ubii.sessions.IOMapping': { encode: encodeIOMapping, decode: decodeIOMapping },
  'ubii.sessions.IOMappingList': { encode: encodeIOMappingList, decode: decodeIOMappingList },
  'ubii.sessions.Session': { encode: encodeSession, decode: decodeSession },
  'ubii.sessions.SessionList': { encode: encodeSessionList, decode: decodeSessionList },
  'ubii.sessions.TopicInputMapping': { encode: encodeTopicInputMapping, decode: decodeTopicInputMapping },
  'ubii.sessions.TopicInputMappingList': { encode: encodeTopicInputMappingList, decode: decodeTopicInputMappingList },
  'ubii.sessions.TopicOutputMapping': { encode: encodeTopicOutputMapping, decode: decodeTopicOutputMapping },
  'ubii.sessions.TopicOutputMappingList': { encode: encodeTopicOutputMappingList, decode: decodeTopicOutputMappingList },
  'ubii.topicData.Timestamp': { encode: encodeTimestamp, decode: decodeTimestamp },
  'ubii.topicData.TopicData': { encode: encodeTopicData, decode: decodeTopicData },
  'ubii.topicData.TopicDataRecord': { encode: encodeTopicDataRecord, decode: decodeTopicDataRecord },
  'ubii.topicData.TopicDataRecordList': { encode: encodeTopicDataRecordList, decode: decodeTopicDataRecordList },
  'ubii.topicData.TopicDataSource': { encode: encodeTopicDataSource, decode: decodeTopicDataSource },
  'ubii.topicData.TopicDataSourceList': { encode: encodeTopicDataSourceList, decode: decodeTopicDataSourceList },
};
