// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.

import { only, setMember } from '../binary/oneof.ts';
import type { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import type { Writer } from '../binary/writer.ts';
import type { Init } from '../init.ts';
import type * as T from './messages.ts';

export function encodeClient(m: Init<T.Client>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.devices != null) for (const e of m.devices) { const at = w.open(26); encodeDevice(e, w); w.close(at); }
  if (m.tags != null) for (const e of m.tags) w.string(34, e);
  if (m.description != null) w.string(42, m.description);
  if (m.processingModules != null) for (const e of m.processingModules) { const at = w.open(50); encodeProcessingModule(e, w); w.close(at); }
  if (m.isDedicatedProcessingNode != null) w.bool(56, m.isDedicatedProcessingNode);
  if (m.hostIp != null) w.string(66, m.hostIp);
  if (m.metadataJson != null) w.string(74, m.metadataJson);
  if (m.state != null) w.int32(80, m.state);
  if (m.latency != null) w.float(93, m.latency);
  if (m.extension != null) { const at = w.open(8002); encodeClientExtension(m.extension, w); w.close(at); }
}

export function decodeClient(r: Reader, into?: T.Client): T.Client {
  const m: T.Client = into ?? { id: '', name: '', devices: [], tags: [], description: '', processingModules: [], isDedicatedProcessingNode: false, hostIp: '', metadataJson: '', state: 0, latency: 0, extension: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: { const end = r.enter(); m.devices.push(decodeDevice(r)); r.end = end; break; }
      case 34: m.tags.push(r.string()); break;
      case 42: m.description = r.string(); break;
      case 50: { const end = r.enter(); m.processingModules.push(decodeProcessingModule(r)); r.end = end; break; }
      case 56: m.isDedicatedProcessingNode = r.bool(); break;
      case 66: m.hostIp = r.string(); break;
      case 74: m.metadataJson = r.string(); break;
      case 80: m.state = r.int32() as T.ClientState; break;
      case 93: m.latency = r.float(); break;
      case 8002: { const end = r.enter(); m.extension = decodeClientExtension(r, m.extension); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientList(m: Init<T.ClientList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeClient(e, w); w.close(at); }
}

export function decodeClientList(r: Reader, into?: T.ClientList): T.ClientList {
  const m: T.ClientList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeClient(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNotifyCondition(m: Init<T.NotifyCondition>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.evaluationFunctionStringified != null) w.string(26, m.evaluationFunctionStringified);
  if (m.clientProfilePub != null) { const at = w.open(34); encodeClient(m.clientProfilePub, w); w.close(at); }
  if (m.clientProfileSub != null) { const at = w.open(42); encodeClient(m.clientProfileSub, w); w.close(at); }
}

export function decodeNotifyCondition(r: Reader, into?: T.NotifyCondition): T.NotifyCondition {
  const m: T.NotifyCondition = into ?? { id: '', name: '', evaluationFunctionStringified: '', clientProfilePub: undefined, clientProfileSub: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.evaluationFunctionStringified = r.string(); break;
      case 34: { const end = r.enter(); m.clientProfilePub = decodeClient(r, m.clientProfilePub); r.end = end; break; }
      case 42: { const end = r.enter(); m.clientProfileSub = decodeClient(r, m.clientProfileSub); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBoolList(m: Init<T.BoolList>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.bools(10, m.elements);
}

export function decodeBoolList(r: Reader, into?: T.BoolList): T.BoolList {
  const m: T.BoolList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.elements.push(r.bool()); break;
      case 10: r.bools(m.elements); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeColor(m: Init<T.Color>, w: Writer): void {
  if (m.r != null) w.double(9, m.r);
  if (m.g != null) w.double(17, m.g);
  if (m.b != null) w.double(25, m.b);
  if (m.a != null) w.double(33, m.a);
}

export function decodeColor(r: Reader, into?: T.Color): T.Color {
  const m: T.Color = into ?? { r: 0, g: 0, b: 0, a: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.r = r.double(); break;
      case 17: m.g = r.double(); break;
      case 25: m.b = r.double(); break;
      case 33: m.a = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeDoubleList(m: Init<T.DoubleList>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.doubles(10, m.elements);
}

export function decodeDoubleList(r: Reader, into?: T.DoubleList): T.DoubleList {
  const m: T.DoubleList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.elements.push(r.double()); break;
      case 10: r.doubles(m.elements); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeFloatList(m: Init<T.FloatList>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.floats(10, m.elements);
}

export function decodeFloatList(r: Reader, into?: T.FloatList): T.FloatList {
  const m: T.FloatList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 13: m.elements.push(r.float()); break;
      case 10: r.floats(m.elements); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeImage2D(m: Init<T.Image2D>, w: Writer): void {
  if (m.width != null) w.int32(8, m.width);
  if (m.height != null) w.int32(16, m.height);
  if (m.dataFormat != null) w.int32(24, m.dataFormat);
  if (m.data != null) w.bytes(34, m.data);
}

export function decodeImage2D(r: Reader, into?: T.Image2D): T.Image2D {
  const m: T.Image2D = into ?? { width: 0, height: 0, dataFormat: 0, data: new Uint8Array(0) };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.width = r.int32(); break;
      case 16: m.height = r.int32(); break;
      case 24: m.dataFormat = r.int32() as T.Image2DDataFormat; break;
      case 34: m.data = r.bytes(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeImage2DList(m: Init<T.Image2DList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeImage2D(e, w); w.close(at); }
}

export function decodeImage2DList(r: Reader, into?: T.Image2DList): T.Image2DList {
  const m: T.Image2DList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeImage2D(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeInt32List(m: Init<T.Int32List>, w: Writer): void {
  if (m.elements != null && m.elements.length > 0) w.int32s(10, m.elements);
}

export function decodeInt32List(r: Reader, into?: T.Int32List): T.Int32List {
  const m: T.Int32List = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.elements.push(r.int32()); break;
      case 10: r.int32s(m.elements); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeKeyEvent(m: Init<T.KeyEvent>, w: Writer): void {
  if (m.type != null) w.int32(8, m.type);
  if (m.key != null) w.string(18, m.key);
}

export function decodeKeyEvent(r: Reader, into?: T.KeyEvent): T.KeyEvent {
  const m: T.KeyEvent = into ?? { type: 0, key: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.type = r.int32() as T.ButtonEventType; break;
      case 18: m.key = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMatrix3x2(m: Init<T.Matrix3x2>, w: Writer): void {
  if (m.m00 != null) w.double(9, m.m00);
  if (m.m01 != null) w.double(17, m.m01);
  if (m.m10 != null) w.double(25, m.m10);
  if (m.m11 != null) w.double(33, m.m11);
  if (m.m20 != null) w.double(41, m.m20);
  if (m.m21 != null) w.double(49, m.m21);
}

export function decodeMatrix3x2(r: Reader, into?: T.Matrix3x2): T.Matrix3x2 {
  const m: T.Matrix3x2 = into ?? { m00: 0, m01: 0, m10: 0, m11: 0, m20: 0, m21: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.m00 = r.double(); break;
      case 17: m.m01 = r.double(); break;
      case 25: m.m10 = r.double(); break;
      case 33: m.m11 = r.double(); break;
      case 41: m.m20 = r.double(); break;
      case 49: m.m21 = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMatrix4x4(m: Init<T.Matrix4x4>, w: Writer): void {
  if (m.m00 != null) w.double(9, m.m00);
  if (m.m01 != null) w.double(17, m.m01);
  if (m.m02 != null) w.double(25, m.m02);
  if (m.m03 != null) w.double(33, m.m03);
  if (m.m10 != null) w.double(41, m.m10);
  if (m.m11 != null) w.double(49, m.m11);
  if (m.m12 != null) w.double(57, m.m12);
  if (m.m13 != null) w.double(65, m.m13);
  if (m.m20 != null) w.double(73, m.m20);
  if (m.m21 != null) w.double(81, m.m21);
  if (m.m22 != null) w.double(89, m.m22);
  if (m.m23 != null) w.double(97, m.m23);
  if (m.m30 != null) w.double(105, m.m30);
  if (m.m31 != null) w.double(113, m.m31);
  if (m.m32 != null) w.double(121, m.m32);
  if (m.m33 != null) w.double(129, m.m33);
}

export function decodeMatrix4x4(r: Reader, into?: T.Matrix4x4): T.Matrix4x4 {
  const m: T.Matrix4x4 = into ?? { m00: 0, m01: 0, m02: 0, m03: 0, m10: 0, m11: 0, m12: 0, m13: 0, m20: 0, m21: 0, m22: 0, m23: 0, m30: 0, m31: 0, m32: 0, m33: 0 };
  while (r.pos < r.end) {
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
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMouseEventMessage(m: Init<T.MouseEventMessage>, w: Writer): void {
  if (m.type != null) w.int32(8, m.type);
  if (m.button != null) w.int32(16, m.button);
}

export function decodeMouseEventMessage(r: Reader, into?: T.MouseEventMessage): T.MouseEventMessage {
  const m: T.MouseEventMessage = into ?? { type: 0, button: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.type = r.int32() as T.ButtonEventType; break;
      case 16: m.button = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMyoEvent(m: Init<T.MyoEvent>, w: Writer): void {
  if (m.emg != null) { const at = w.open(10); encodeVector8(m.emg, w); w.close(at); }
  if (m.orientation != null) { const at = w.open(18); encodeQuaternion(m.orientation, w); w.close(at); }
  if (m.gyroscope != null) { const at = w.open(26); encodeVector3(m.gyroscope, w); w.close(at); }
  if (m.accelerometer != null) { const at = w.open(34); encodeVector3(m.accelerometer, w); w.close(at); }
  if (m.gesture != null) w.int32(40, m.gesture);
}

export function decodeMyoEvent(r: Reader, into?: T.MyoEvent): T.MyoEvent {
  const m: T.MyoEvent = into ?? { emg: undefined, orientation: undefined, gyroscope: undefined, accelerometer: undefined, gesture: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.emg = decodeVector8(r, m.emg); r.end = end; break; }
      case 18: { const end = r.enter(); m.orientation = decodeQuaternion(r, m.orientation); r.end = end; break; }
      case 26: { const end = r.enter(); m.gyroscope = decodeVector3(r, m.gyroscope); r.end = end; break; }
      case 34: { const end = r.enter(); m.accelerometer = decodeVector3(r, m.accelerometer); r.end = end; break; }
      case 40: m.gesture = r.int32() as T.HandGestureType; break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeObject2D(m: Init<T.Object2D>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.pose != null) { const at = w.open(18); encodePose2D(m.pose, w); w.close(at); }
  if (m.size != null) { const at = w.open(26); encodeVector2(m.size, w); w.close(at); }
  if (m.userDataJson != null) w.string(34, m.userDataJson);
}

export function decodeObject2D(r: Reader, into?: T.Object2D): T.Object2D {
  const m: T.Object2D = into ?? { id: '', pose: undefined, size: undefined, userDataJson: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: { const end = r.enter(); m.pose = decodePose2D(r, m.pose); r.end = end; break; }
      case 26: { const end = r.enter(); m.size = decodeVector2(r, m.size); r.end = end; break; }
      case 34: m.userDataJson = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeObject2DList(m: Init<T.Object2DList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeObject2D(e, w); w.close(at); }
}

export function decodeObject2DList(r: Reader, into?: T.Object2DList): T.Object2DList {
  const m: T.Object2DList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeObject2D(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeObject3D(m: Init<T.Object3D>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.pose != null) { const at = w.open(18); encodePose3D(m.pose, w); w.close(at); }
  if (m.size != null) { const at = w.open(26); encodeVector3(m.size, w); w.close(at); }
  if (m.userDataJson != null) w.string(34, m.userDataJson);
}

export function decodeObject3D(r: Reader, into?: T.Object3D): T.Object3D {
  const m: T.Object3D = into ?? { id: '', pose: undefined, size: undefined, userDataJson: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: { const end = r.enter(); m.pose = decodePose3D(r, m.pose); r.end = end; break; }
      case 26: { const end = r.enter(); m.size = decodeVector3(r, m.size); r.end = end; break; }
      case 34: m.userDataJson = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeObject3DList(m: Init<T.Object3DList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeObject3D(e, w); w.close(at); }
}

export function decodeObject3DList(r: Reader, into?: T.Object3DList): T.Object3DList {
  const m: T.Object3DList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeObject3D(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodePose2D(m: Init<T.Pose2D>, w: Writer): void {
  if (m.position != null) { const at = w.open(10); encodeVector2(m.position, w); w.close(at); }
  if (m.direction != null) { const at = w.open(18); encodeVector2(m.direction, w); w.close(at); }
  if (m.angle != null) w.float(29, m.angle);
}

const Pose2D_orientation = ['direction', 'angle'] as const;
export function decodePose2D(r: Reader, into?: T.Pose2D): T.Pose2D {
  const m: T.Pose2D = into ?? { position: undefined };
  let orientation = into && setMember(into, Pose2D_orientation);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.position = decodeVector2(r, m.position); r.end = end; break; }
      case 18: orientation = only(m, orientation, 'direction'); { const end = r.enter(); m.direction = decodeVector2(r, m.direction); r.end = end; break; }
      case 29: orientation = only(m, orientation, 'angle'); m.angle = r.float(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodePose3D(m: Init<T.Pose3D>, w: Writer): void {
  if (m.position != null) { const at = w.open(10); encodeVector3(m.position, w); w.close(at); }
  if (m.quaternion != null) { const at = w.open(18); encodeQuaternion(m.quaternion, w); w.close(at); }
  if (m.euler != null) { const at = w.open(26); encodeVector3(m.euler, w); w.close(at); }
}

const Pose3D_orientation = ['quaternion', 'euler'] as const;
export function decodePose3D(r: Reader, into?: T.Pose3D): T.Pose3D {
  const m: T.Pose3D = into ?? { position: undefined };
  let orientation = into && setMember(into, Pose3D_orientation);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.position = decodeVector3(r, m.position); r.end = end; break; }
      case 18: orientation = only(m, orientation, 'quaternion'); { const end = r.enter(); m.quaternion = decodeQuaternion(r, m.quaternion); r.end = end; break; }
      case 26: orientation = only(m, orientation, 'euler'); { const end = r.enter(); m.euler = decodeVector3(r, m.euler); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeQuaternion(m: Init<T.Quaternion>, w: Writer): void {
  if (m.x != null) w.double(9, m.x);
  if (m.y != null) w.double(17, m.y);
  if (m.z != null) w.double(25, m.z);
  if (m.w != null) w.double(33, m.w);
}

export function decodeQuaternion(r: Reader, into?: T.Quaternion): T.Quaternion {
  const m: T.Quaternion = into ?? { x: 0, y: 0, z: 0, w: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      case 25: m.z = r.double(); break;
      case 33: m.w = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeQuaternionList(m: Init<T.QuaternionList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeQuaternion(e, w); w.close(at); }
}

export function decodeQuaternionList(r: Reader, into?: T.QuaternionList): T.QuaternionList {
  const m: T.QuaternionList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeQuaternion(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStringList(m: Init<T.StringList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) w.string(10, e);
}

export function decodeStringList(r: Reader, into?: T.StringList): T.StringList {
  const m: T.StringList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.elements.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTouchEventMessage(m: Init<T.TouchEventMessage>, w: Writer): void {
  if (m.type != null) w.int32(8, m.type);
  if (m.position != null) { const at = w.open(18); encodeVector2(m.position, w); w.close(at); }
  if (m.id != null) w.string(26, m.id);
  if (m.force != null) w.float(37, m.force);
}

export function decodeTouchEventMessage(r: Reader, into?: T.TouchEventMessage): T.TouchEventMessage {
  const m: T.TouchEventMessage = into ?? { type: 0, position: undefined, id: '', force: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.type = r.int32() as T.TouchEventType; break;
      case 18: { const end = r.enter(); m.position = decodeVector2(r, m.position); r.end = end; break; }
      case 26: m.id = r.string(); break;
      case 37: m.force = r.float(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTouchEventList(m: Init<T.TouchEventList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTouchEventMessage(e, w); w.close(at); }
}

export function decodeTouchEventList(r: Reader, into?: T.TouchEventList): T.TouchEventList {
  const m: T.TouchEventList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTouchEventMessage(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector2(m: Init<T.Vector2>, w: Writer): void {
  if (m.x != null) w.double(9, m.x);
  if (m.y != null) w.double(17, m.y);
}

export function decodeVector2(r: Reader, into?: T.Vector2): T.Vector2 {
  const m: T.Vector2 = into ?? { x: 0, y: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector2List(m: Init<T.Vector2List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeVector2(e, w); w.close(at); }
}

export function decodeVector2List(r: Reader, into?: T.Vector2List): T.Vector2List {
  const m: T.Vector2List = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeVector2(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector3(m: Init<T.Vector3>, w: Writer): void {
  if (m.x != null) w.double(9, m.x);
  if (m.y != null) w.double(17, m.y);
  if (m.z != null) w.double(25, m.z);
}

export function decodeVector3(r: Reader, into?: T.Vector3): T.Vector3 {
  const m: T.Vector3 = into ?? { x: 0, y: 0, z: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      case 25: m.z = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector3List(m: Init<T.Vector3List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeVector3(e, w); w.close(at); }
}

export function decodeVector3List(r: Reader, into?: T.Vector3List): T.Vector3List {
  const m: T.Vector3List = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeVector3(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector4(m: Init<T.Vector4>, w: Writer): void {
  if (m.x != null) w.double(9, m.x);
  if (m.y != null) w.double(17, m.y);
  if (m.z != null) w.double(25, m.z);
  if (m.w != null) w.double(33, m.w);
}

export function decodeVector4(r: Reader, into?: T.Vector4): T.Vector4 {
  const m: T.Vector4 = into ?? { x: 0, y: 0, z: 0, w: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.x = r.double(); break;
      case 17: m.y = r.double(); break;
      case 25: m.z = r.double(); break;
      case 33: m.w = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector4List(m: Init<T.Vector4List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeVector4(e, w); w.close(at); }
}

export function decodeVector4List(r: Reader, into?: T.Vector4List): T.Vector4List {
  const m: T.Vector4List = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeVector4(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector8(m: Init<T.Vector8>, w: Writer): void {
  if (m.v0 != null) w.double(9, m.v0);
  if (m.v1 != null) w.double(17, m.v1);
  if (m.v2 != null) w.double(25, m.v2);
  if (m.v3 != null) w.double(33, m.v3);
  if (m.v4 != null) w.double(41, m.v4);
  if (m.v5 != null) w.double(49, m.v5);
  if (m.v6 != null) w.double(57, m.v6);
  if (m.v7 != null) w.double(65, m.v7);
}

export function decodeVector8(r: Reader, into?: T.Vector8): T.Vector8 {
  const m: T.Vector8 = into ?? { v0: 0, v1: 0, v2: 0, v3: 0, v4: 0, v5: 0, v6: 0, v7: 0 };
  while (r.pos < r.end) {
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
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeVector8List(m: Init<T.Vector8List>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeVector8(e, w); w.close(at); }
}

export function decodeVector8List(r: Reader, into?: T.Vector8List): T.Vector8List {
  const m: T.Vector8List = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeVector8(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeComponent(m: Init<T.Component>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.messageFormat != null) w.string(18, m.messageFormat);
  if (m.ioType != null) w.int32(24, m.ioType);
  if (m.deviceId != null) w.string(34, m.deviceId);
  if (m.tags != null) for (const e of m.tags) w.string(42, e);
  if (m.description != null) w.string(50, m.description);
  if (m.id != null) w.string(58, m.id);
  if (m.name != null) w.string(66, m.name);
  if (m.notifyConditionIds != null) for (const e of m.notifyConditionIds) w.string(74, e);
}

export function decodeComponent(r: Reader, into?: T.Component): T.Component {
  const m: T.Component = into ?? { topic: '', messageFormat: '', ioType: 0, deviceId: '', tags: [], description: '', id: '', name: '', notifyConditionIds: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.messageFormat = r.string(); break;
      case 24: m.ioType = r.int32() as T.ComponentIOType; break;
      case 34: m.deviceId = r.string(); break;
      case 42: m.tags.push(r.string()); break;
      case 50: m.description = r.string(); break;
      case 58: m.id = r.string(); break;
      case 66: m.name = r.string(); break;
      case 74: m.notifyConditionIds.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeComponentList(m: Init<T.ComponentList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeComponent(e, w); w.close(at); }
}

export function decodeComponentList(r: Reader, into?: T.ComponentList): T.ComponentList {
  const m: T.ComponentList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeComponent(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeDevice(m: Init<T.Device>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.deviceType != null) w.int32(24, m.deviceType);
  if (m.components != null) for (const e of m.components) { const at = w.open(34); encodeComponent(e, w); w.close(at); }
  if (m.clientId != null) w.string(42, m.clientId);
  if (m.tags != null) for (const e of m.tags) w.string(50, e);
  if (m.description != null) w.string(58, m.description);
}

export function decodeDevice(r: Reader, into?: T.Device): T.Device {
  const m: T.Device = into ?? { id: '', name: '', deviceType: 0, components: [], clientId: '', tags: [], description: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 24: m.deviceType = r.int32() as T.DeviceType; break;
      case 34: { const end = r.enter(); m.components.push(decodeComponent(r)); r.end = end; break; }
      case 42: m.clientId = r.string(); break;
      case 50: m.tags.push(r.string()); break;
      case 58: m.description = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeDeviceList(m: Init<T.DeviceList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeDevice(e, w); w.close(at); }
}

export function decodeDeviceList(r: Reader, into?: T.DeviceList): T.DeviceList {
  const m: T.DeviceList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeDevice(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicDemux(m: Init<T.TopicDemux>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.dataType != null) w.string(26, m.dataType);
  if (m.outputTopicFormat != null) w.string(34, m.outputTopicFormat);
}

export function decodeTopicDemux(r: Reader, into?: T.TopicDemux): T.TopicDemux {
  const m: T.TopicDemux = into ?? { id: '', name: '', dataType: '', outputTopicFormat: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.dataType = r.string(); break;
      case 34: m.outputTopicFormat = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicDemuxList(m: Init<T.TopicDemuxList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicDemux(e, w); w.close(at); }
}

export function decodeTopicDemuxList(r: Reader, into?: T.TopicDemuxList): T.TopicDemuxList {
  const m: T.TopicDemuxList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicDemux(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicMux(m: Init<T.TopicMux>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.dataType != null) w.string(26, m.dataType);
  if (m.topicSelector != null) w.string(34, m.topicSelector);
  if (m.identityMatchPattern != null) w.string(42, m.identityMatchPattern);
  if (m.topicGlob != null) w.string(8002, m.topicGlob);
  if (m.component != null) { const at = w.open(8010); encodeComponent(m.component, w); w.close(at); }
  if (m.identitySource != null) w.int32(8016, m.identitySource);
  if (m.identityGroup != null) w.int32(8024, m.identityGroup);
}

export function decodeTopicMux(r: Reader, into?: T.TopicMux): T.TopicMux {
  const m: T.TopicMux = into ?? { id: '', name: '', dataType: '', topicSelector: '', identityMatchPattern: '', topicGlob: '', component: undefined, identitySource: 0, identityGroup: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.dataType = r.string(); break;
      case 34: m.topicSelector = r.string(); break;
      case 42: m.identityMatchPattern = r.string(); break;
      case 8002: m.topicGlob = r.string(); break;
      case 8010: { const end = r.enter(); m.component = decodeComponent(r, m.component); r.end = end; break; }
      case 8016: m.identitySource = r.int32() as T.MuxIdentity; break;
      case 8024: m.identityGroup = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicMuxList(m: Init<T.TopicMuxList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicMux(e, w); w.close(at); }
}

export function decodeTopicMuxList(r: Reader, into?: T.TopicMuxList): T.TopicMuxList {
  const m: T.TopicMuxList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicMux(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAccessGrant(m: Init<T.AccessGrant>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.label != null) w.string(18, m.label);
  if (m.role != null) w.int32(24, m.role);
  if (m.target != null) w.string(34, m.target);
  if (m.createdMs != null) w.double(41, m.createdMs);
  if (m.expiresMs != null) w.double(49, m.expiresMs);
  if (m.maxJoins != null) w.int32(56, m.maxJoins);
  if (m.readTopics != null) for (const e of m.readTopics) w.string(66, e);
  if (m.writeTopics != null) for (const e of m.writeTopics) w.string(74, e);
  if (m.revokedMs != null) w.double(81, m.revokedMs);
  if (m.joins != null) w.int32(88, m.joins);
  if (m.clientIds != null) for (const e of m.clientIds) w.string(98, e);
  if (m.isTerminal != null) w.bool(104, m.isTerminal);
  if (m.codeExpiresMs != null) w.double(113, m.codeExpiresMs);
  if (m.staysUntilMs != null) w.double(121, m.staysUntilMs);
  if (m.sessionIds != null) for (const e of m.sessionIds) w.string(130, e);
  if (m.runningSessionIds != null) for (const e of m.runningSessionIds) w.string(138, e);
  if (m.storedSessionNames != null) for (const e of m.storedSessionNames) w.string(146, e);
  if (m.moduleNames != null) for (const e of m.moduleNames) w.string(154, e);
}

export function decodeAccessGrant(r: Reader, into?: T.AccessGrant): T.AccessGrant {
  const m: T.AccessGrant = into ?? { id: '', label: '', role: 0, target: '', createdMs: 0, expiresMs: 0, maxJoins: 0, readTopics: [], writeTopics: [], revokedMs: 0, joins: 0, clientIds: [], isTerminal: false, codeExpiresMs: 0, staysUntilMs: 0, sessionIds: [], runningSessionIds: [], storedSessionNames: [], moduleNames: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.label = r.string(); break;
      case 24: m.role = r.int32() as T.AccessRole; break;
      case 34: m.target = r.string(); break;
      case 41: m.createdMs = r.double(); break;
      case 49: m.expiresMs = r.double(); break;
      case 56: m.maxJoins = r.int32(); break;
      case 66: m.readTopics.push(r.string()); break;
      case 74: m.writeTopics.push(r.string()); break;
      case 81: m.revokedMs = r.double(); break;
      case 88: m.joins = r.int32(); break;
      case 98: m.clientIds.push(r.string()); break;
      case 104: m.isTerminal = r.bool(); break;
      case 113: m.codeExpiresMs = r.double(); break;
      case 121: m.staysUntilMs = r.double(); break;
      case 130: m.sessionIds.push(r.string()); break;
      case 138: m.runningSessionIds.push(r.string()); break;
      case 146: m.storedSessionNames.push(r.string()); break;
      case 154: m.moduleNames.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAccessGrantCreateRequest(m: Init<T.AccessGrantCreateRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.label != null) w.string(18, m.label);
  if (m.role != null) w.int32(24, m.role);
  if (m.target != null) w.string(34, m.target);
  if (m.lifetimeMs != null) w.double(41, m.lifetimeMs);
  if (m.maxJoins != null) w.int32(48, m.maxJoins);
  if (m.readTopics != null) for (const e of m.readTopics) w.string(58, e);
  if (m.writeTopics != null) for (const e of m.writeTopics) w.string(66, e);
  if (m.stayMs != null) w.double(73, m.stayMs);
}

export function decodeAccessGrantCreateRequest(r: Reader, into?: T.AccessGrantCreateRequest): T.AccessGrantCreateRequest {
  const m: T.AccessGrantCreateRequest = into ?? { clientId: '', label: '', role: 0, target: '', lifetimeMs: 0, maxJoins: 0, readTopics: [], writeTopics: [], stayMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.label = r.string(); break;
      case 24: m.role = r.int32() as T.AccessRole; break;
      case 34: m.target = r.string(); break;
      case 41: m.lifetimeMs = r.double(); break;
      case 48: m.maxJoins = r.int32(); break;
      case 58: m.readTopics.push(r.string()); break;
      case 66: m.writeTopics.push(r.string()); break;
      case 73: m.stayMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAccessGrantCreated(m: Init<T.AccessGrantCreated>, w: Writer): void {
  if (m.grant != null) { const at = w.open(10); encodeAccessGrant(m.grant, w); w.close(at); }
  if (m.token != null) w.string(18, m.token);
  if (m.code != null) w.string(26, m.code);
}

export function decodeAccessGrantCreated(r: Reader, into?: T.AccessGrantCreated): T.AccessGrantCreated {
  const m: T.AccessGrantCreated = into ?? { grant: undefined, token: '', code: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.grant = decodeAccessGrant(r, m.grant); r.end = end; break; }
      case 18: m.token = r.string(); break;
      case 26: m.code = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAccessGrantList(m: Init<T.AccessGrantList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeAccessGrant(e, w); w.close(at); }
}

export function decodeAccessGrantList(r: Reader, into?: T.AccessGrantList): T.AccessGrantList {
  const m: T.AccessGrantList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeAccessGrant(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAccessGrantRevokeRequest(m: Init<T.AccessGrantRevokeRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.grantId != null) w.string(18, m.grantId);
  if (m.reason != null) w.string(26, m.reason);
  if (m.work != null) w.int32(32, m.work);
}

export function decodeAccessGrantRevokeRequest(r: Reader, into?: T.AccessGrantRevokeRequest): T.AccessGrantRevokeRequest {
  const m: T.AccessGrantRevokeRequest = into ?? { clientId: '', grantId: '', reason: '', work: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.grantId = r.string(); break;
      case 26: m.reason = r.string(); break;
      case 32: m.work = r.int32() as T.RevokedWork; break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAssetSet(m: Init<T.AssetSet>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
  if (m.description != null) w.string(18, m.description);
  if (m.version != null) w.string(26, m.version);
  if (m.licence != null) w.string(34, m.licence);
  if (m.source != null) w.string(42, m.source);
  if (m.bytes != null) w.double(49, m.bytes);
  if (m.files != null) w.int32(56, m.files);
  if (m.state != null) w.int32(64, m.state);
  if (m.problem != null) w.string(74, m.problem);
  if (m.bundled != null) w.bool(80, m.bundled);
  if (m.address != null) w.string(90, m.address);
  if (m.folder != null) w.string(98, m.folder);
  if (m.download != null) { const at = w.open(106); encodeAssetSetDownload(m.download, w); w.close(at); }
  if (m.publisherAddress != null) w.string(114, m.publisherAddress);
}

export function decodeAssetSet(r: Reader, into?: T.AssetSet): T.AssetSet {
  const m: T.AssetSet = into ?? { name: '', description: '', version: '', licence: '', source: '', bytes: 0, files: 0, state: 0, problem: '', bundled: false, address: '', folder: '', download: undefined, publisherAddress: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      case 18: m.description = r.string(); break;
      case 26: m.version = r.string(); break;
      case 34: m.licence = r.string(); break;
      case 42: m.source = r.string(); break;
      case 49: m.bytes = r.double(); break;
      case 56: m.files = r.int32(); break;
      case 64: m.state = r.int32() as T.AssetSetState; break;
      case 74: m.problem = r.string(); break;
      case 80: m.bundled = r.bool(); break;
      case 90: m.address = r.string(); break;
      case 98: m.folder = r.string(); break;
      case 106: { const end = r.enter(); m.download = decodeAssetSetDownload(r, m.download); r.end = end; break; }
      case 114: m.publisherAddress = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAssetSetDownload(m: Init<T.AssetSetDownload>, w: Writer): void {
  if (m.running != null) w.bool(8, m.running);
  if (m.loadedBytes != null) w.double(17, m.loadedBytes);
  if (m.totalBytes != null) w.double(25, m.totalBytes);
  if (m.elapsedMs != null) w.double(33, m.elapsedMs);
  if (m.error != null) w.string(42, m.error);
}

export function decodeAssetSetDownload(r: Reader, into?: T.AssetSetDownload): T.AssetSetDownload {
  const m: T.AssetSetDownload = into ?? { running: false, loadedBytes: 0, totalBytes: 0, elapsedMs: 0, error: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.running = r.bool(); break;
      case 17: m.loadedBytes = r.double(); break;
      case 25: m.totalBytes = r.double(); break;
      case 33: m.elapsedMs = r.double(); break;
      case 42: m.error = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAssetSetList(m: Init<T.AssetSetList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeAssetSet(e, w); w.close(at); }
}

export function decodeAssetSetList(r: Reader, into?: T.AssetSetList): T.AssetSetList {
  const m: T.AssetSetList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeAssetSet(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAssetSetRequest(m: Init<T.AssetSetRequest>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
}

export function decodeAssetSetRequest(r: Reader, into?: T.AssetSetRequest): T.AssetSetRequest {
  const m: T.AssetSetRequest = into ?? { name: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAuditEntry(m: Init<T.AuditEntry>, w: Writer): void {
  if (m.number != null) w.double(9, m.number);
  if (m.timeMs != null) w.double(17, m.timeMs);
  if (m.service != null) w.string(26, m.service);
  if (m.object != null) w.string(34, m.object);
  if (m.error != null) w.string(42, m.error);
  if (m.clientId != null) w.string(50, m.clientId);
  if (m.clientName != null) w.string(58, m.clientName);
  if (m.role != null) w.int32(64, m.role);
  if (m.way != null) w.int32(72, m.way);
  if (m.grantId != null) w.string(82, m.grantId);
  if (m.grantLabel != null) w.string(90, m.grantLabel);
  if (m.addressKind != null) w.int32(96, m.addressKind);
  if (m.leftOut != null) w.int32(104, m.leftOut);
}

export function decodeAuditEntry(r: Reader, into?: T.AuditEntry): T.AuditEntry {
  const m: T.AuditEntry = into ?? { number: 0, timeMs: 0, service: '', object: '', error: '', clientId: '', clientName: '', role: 0, way: 0, grantId: '', grantLabel: '', addressKind: 0, leftOut: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.number = r.double(); break;
      case 17: m.timeMs = r.double(); break;
      case 26: m.service = r.string(); break;
      case 34: m.object = r.string(); break;
      case 42: m.error = r.string(); break;
      case 50: m.clientId = r.string(); break;
      case 58: m.clientName = r.string(); break;
      case 64: m.role = r.int32() as T.AccessRole; break;
      case 72: m.way = r.int32() as T.AuditEntryWay; break;
      case 82: m.grantId = r.string(); break;
      case 90: m.grantLabel = r.string(); break;
      case 96: m.addressKind = r.int32() as T.ClientActivityAddressKind; break;
      case 104: m.leftOut = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAuditLog(m: Init<T.AuditLog>, w: Writer): void {
  if (m.entries != null) for (const e of m.entries) { const at = w.open(10); encodeAuditEntry(e, w); w.close(at); }
  if (m.more != null) w.bool(16, m.more);
  if (m.kept != null) w.int32(24, m.kept);
}

export function decodeAuditLog(r: Reader, into?: T.AuditLog): T.AuditLog {
  const m: T.AuditLog = into ?? { entries: [], more: false, kept: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.entries.push(decodeAuditEntry(r)); r.end = end; break; }
      case 16: m.more = r.bool(); break;
      case 24: m.kept = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeAuditLogRequest(m: Init<T.AuditLogRequest>, w: Writer): void {
  if (m.before != null) w.double(9, m.before);
  if (m.count != null) w.int32(16, m.count);
  if (m.clientId != null) w.string(26, m.clientId);
  if (m.grantId != null) w.string(34, m.grantId);
  if (m.service != null) w.string(42, m.service);
  if (m.text != null) w.string(50, m.text);
}

export function decodeAuditLogRequest(r: Reader, into?: T.AuditLogRequest): T.AuditLogRequest {
  const m: T.AuditLogRequest = into ?? { before: 0, count: 0, clientId: '', grantId: '', service: '', text: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.before = r.double(); break;
      case 16: m.count = r.int32(); break;
      case 26: m.clientId = r.string(); break;
      case 34: m.grantId = r.string(); break;
      case 42: m.service = r.string(); break;
      case 50: m.text = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientActivity(m: Init<T.ClientActivity>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.firstSeenMs != null) w.double(17, m.firstSeenMs);
  if (m.lastSeenMs != null) w.double(25, m.lastSeenMs);
  if (m.connected != null) w.bool(32, m.connected);
  if (m.connectedMs != null) w.double(41, m.connectedMs);
  if (m.roundTripMs != null) w.double(49, m.roundTripMs);
  if (m.roundTripAgeMs != null) w.double(57, m.roundTripAgeMs);
  if (m.recordsIn != null) w.double(65, m.recordsIn);
  if (m.bytesIn != null) w.double(73, m.bytesIn);
  if (m.recordsOut != null) w.double(81, m.recordsOut);
  if (m.bytesOut != null) w.double(89, m.bytesOut);
  if (m.recordsInPerSecond != null) w.double(97, m.recordsInPerSecond);
  if (m.bytesInPerSecond != null) w.double(105, m.bytesInPerSecond);
  if (m.recordsOutPerSecond != null) w.double(113, m.recordsOutPerSecond);
  if (m.bytesOutPerSecond != null) w.double(121, m.bytesOutPerSecond);
  if (m.queuedRecords != null) w.int32(128, m.queuedRecords);
  if (m.queuedBytes != null) w.double(137, m.queuedBytes);
  if (m.dropped != null) w.double(145, m.dropped);
  if (m.refused != null) w.double(153, m.refused);
  if (m.protocolErrors != null) w.double(161, m.protocolErrors);
  if (m.topicSubscriptions != null) w.int32(168, m.topicSubscriptions);
  if (m.patternSubscriptions != null) w.int32(176, m.patternSubscriptions);
  if (m.componentSubscriptions != null) w.int32(184, m.componentSubscriptions);
  if (m.watchesEverything != null) w.bool(192, m.watchesEverything);
  if (m.subscriptions != null) for (const e of m.subscriptions) { const at = w.open(202); encodeClientSubscription(e, w); w.close(at); }
  if (m.ownedTopics != null) w.int32(208, m.ownedTopics);
  if (m.userAgent != null) w.string(218, m.userAgent);
  if (m.library != null) w.string(226, m.library);
  if (m.addressKind != null) w.int32(232, m.addressKind);
  if (m.throttle != null) { const at = w.open(242); encodeClientThrottle(m.throttle, w); w.close(at); }
  if (m.workShare != null) w.double(249, m.workShare);
  if (m.role != null) w.int32(320, m.role);
  if (m.grantId != null) w.string(330, m.grantId);
  if (m.clock != null) { const at = w.open(338); encodeClientClock(m.clock, w); w.close(at); }
}

export function decodeClientActivity(r: Reader, into?: T.ClientActivity): T.ClientActivity {
  const m: T.ClientActivity = into ?? { clientId: '', firstSeenMs: 0, lastSeenMs: 0, connected: false, connectedMs: 0, roundTripMs: 0, roundTripAgeMs: 0, recordsIn: 0, bytesIn: 0, recordsOut: 0, bytesOut: 0, recordsInPerSecond: 0, bytesInPerSecond: 0, recordsOutPerSecond: 0, bytesOutPerSecond: 0, queuedRecords: 0, queuedBytes: 0, dropped: 0, refused: 0, protocolErrors: 0, topicSubscriptions: 0, patternSubscriptions: 0, componentSubscriptions: 0, watchesEverything: false, subscriptions: [], ownedTopics: 0, userAgent: '', library: '', addressKind: 0, throttle: undefined, workShare: 0, role: 0, grantId: '', clock: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 17: m.firstSeenMs = r.double(); break;
      case 25: m.lastSeenMs = r.double(); break;
      case 32: m.connected = r.bool(); break;
      case 41: m.connectedMs = r.double(); break;
      case 49: m.roundTripMs = r.double(); break;
      case 57: m.roundTripAgeMs = r.double(); break;
      case 65: m.recordsIn = r.double(); break;
      case 73: m.bytesIn = r.double(); break;
      case 81: m.recordsOut = r.double(); break;
      case 89: m.bytesOut = r.double(); break;
      case 97: m.recordsInPerSecond = r.double(); break;
      case 105: m.bytesInPerSecond = r.double(); break;
      case 113: m.recordsOutPerSecond = r.double(); break;
      case 121: m.bytesOutPerSecond = r.double(); break;
      case 128: m.queuedRecords = r.int32(); break;
      case 137: m.queuedBytes = r.double(); break;
      case 145: m.dropped = r.double(); break;
      case 153: m.refused = r.double(); break;
      case 161: m.protocolErrors = r.double(); break;
      case 168: m.topicSubscriptions = r.int32(); break;
      case 176: m.patternSubscriptions = r.int32(); break;
      case 184: m.componentSubscriptions = r.int32(); break;
      case 192: m.watchesEverything = r.bool(); break;
      case 202: { const end = r.enter(); m.subscriptions.push(decodeClientSubscription(r)); r.end = end; break; }
      case 208: m.ownedTopics = r.int32(); break;
      case 218: m.userAgent = r.string(); break;
      case 226: m.library = r.string(); break;
      case 232: m.addressKind = r.int32() as T.ClientActivityAddressKind; break;
      case 242: { const end = r.enter(); m.throttle = decodeClientThrottle(r, m.throttle); r.end = end; break; }
      case 249: m.workShare = r.double(); break;
      case 320: m.role = r.int32() as T.AccessRole; break;
      case 330: m.grantId = r.string(); break;
      case 338: { const end = r.enter(); m.clock = decodeClientClock(r, m.clock); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientClock(m: Init<T.ClientClock>, w: Writer): void {
  if (m.offsetMs != null) w.double(9, m.offsetMs);
  if (m.errorMs != null) w.double(17, m.errorMs);
  if (m.driftPpm != null) w.double(25, m.driftPpm);
  if (m.ageMs != null) w.double(33, m.ageMs);
}

export function decodeClientClock(r: Reader, into?: T.ClientClock): T.ClientClock {
  const m: T.ClientClock = into ?? { offsetMs: 0, errorMs: 0, driftPpm: 0, ageMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.offsetMs = r.double(); break;
      case 17: m.errorMs = r.double(); break;
      case 25: m.driftPpm = r.double(); break;
      case 33: m.ageMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientDisconnectRequest(m: Init<T.ClientDisconnectRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.targetId != null) w.string(18, m.targetId);
  if (m.reason != null) w.string(26, m.reason);
}

export function decodeClientDisconnectRequest(r: Reader, into?: T.ClientDisconnectRequest): T.ClientDisconnectRequest {
  const m: T.ClientDisconnectRequest = into ?? { clientId: '', targetId: '', reason: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.targetId = r.string(); break;
      case 26: m.reason = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientExtension(m: Init<T.ClientExtension>, w: Writer): void {
  if (m.recordLists != null) w.bool(8, m.recordLists);
  if (m.resumeToken != null) w.string(18, m.resumeToken);
  if (m.resumed != null) w.bool(24, m.resumed);
  if (m.masterVersion != null) w.string(34, m.masterVersion);
  if (m.node != null) { const at = w.open(42); encodeNodeExtension(m.node, w); w.close(at); }
  if (m.library != null) w.string(50, m.library);
  if (m.credential != null) w.string(82, m.credential);
  if (m.credentialExpiresMs != null) w.double(89, m.credentialExpiresMs);
  if (m.role != null) w.int32(96, m.role);
  if (m.tellsTime != null) w.bool(160, m.tellsTime);
  if (m.abridged != null) w.bool(240, m.abridged);
  if (m.registrationRevision != null) w.int32(248, m.registrationRevision);
}

export function decodeClientExtension(r: Reader, into?: T.ClientExtension): T.ClientExtension {
  const m: T.ClientExtension = into ?? { recordLists: false, resumeToken: '', resumed: false, masterVersion: '', node: undefined, library: '', credential: '', credentialExpiresMs: 0, role: 0, tellsTime: false, abridged: false, registrationRevision: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.recordLists = r.bool(); break;
      case 18: m.resumeToken = r.string(); break;
      case 24: m.resumed = r.bool(); break;
      case 34: m.masterVersion = r.string(); break;
      case 42: { const end = r.enter(); m.node = decodeNodeExtension(r, m.node); r.end = end; break; }
      case 50: m.library = r.string(); break;
      case 82: m.credential = r.string(); break;
      case 89: m.credentialExpiresMs = r.double(); break;
      case 96: m.role = r.int32() as T.AccessRole; break;
      case 160: m.tellsTime = r.bool(); break;
      case 240: m.abridged = r.bool(); break;
      case 248: m.registrationRevision = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientRenameRequest(m: Init<T.ClientRenameRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.targetId != null) w.string(18, m.targetId);
  if (m.name != null) w.string(26, m.name);
}

export function decodeClientRenameRequest(r: Reader, into?: T.ClientRenameRequest): T.ClientRenameRequest {
  const m: T.ClientRenameRequest = into ?? { clientId: '', targetId: '', name: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.targetId = r.string(); break;
      case 26: m.name = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientReport(m: Init<T.ClientReport>, w: Writer): void {
  if (m.masterTimeMs != null) w.double(9, m.masterTimeMs);
  if (m.measuredMs != null) w.double(17, m.measuredMs);
  if (m.clients != null) for (const e of m.clients) { const at = w.open(26); encodeClientActivity(e, w); w.close(at); }
}

export function decodeClientReport(r: Reader, into?: T.ClientReport): T.ClientReport {
  const m: T.ClientReport = into ?? { masterTimeMs: 0, measuredMs: 0, clients: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.masterTimeMs = r.double(); break;
      case 17: m.measuredMs = r.double(); break;
      case 26: { const end = r.enter(); m.clients.push(decodeClientActivity(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientReportRequest(m: Init<T.ClientReportRequest>, w: Writer): void {
  if (m.clientIds != null) for (const e of m.clientIds) w.string(10, e);
  if (m.subscriptions != null) w.bool(16, m.subscriptions);
}

export function decodeClientReportRequest(r: Reader, into?: T.ClientReportRequest): T.ClientReportRequest {
  const m: T.ClientReportRequest = into ?? { clientIds: [], subscriptions: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientIds.push(r.string()); break;
      case 16: m.subscriptions = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientSubscription(m: Init<T.ClientSubscription>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.pattern != null) w.string(18, m.pattern);
  if (m.component != null) { const at = w.open(26); encodeComponent(m.component, w); w.close(at); }
  if (m.maxRateHz != null) w.double(33, m.maxRateHz);
}

export function decodeClientSubscription(r: Reader, into?: T.ClientSubscription): T.ClientSubscription {
  const m: T.ClientSubscription = into ?? { topic: '', pattern: '', component: undefined, maxRateHz: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.pattern = r.string(); break;
      case 26: { const end = r.enter(); m.component = decodeComponent(r, m.component); r.end = end; break; }
      case 33: m.maxRateHz = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientThrottle(m: Init<T.ClientThrottle>, w: Writer): void {
  if (m.recordsPerSecond != null) w.double(9, m.recordsPerSecond);
  if (m.byPolicy != null) w.bool(16, m.byPolicy);
  if (m.byName != null) w.string(26, m.byName);
  if (m.reason != null) w.string(34, m.reason);
  if (m.sinceMs != null) w.double(41, m.sinceMs);
  if (m.dropped != null) w.double(49, m.dropped);
}

export function decodeClientThrottle(r: Reader, into?: T.ClientThrottle): T.ClientThrottle {
  const m: T.ClientThrottle = into ?? { recordsPerSecond: 0, byPolicy: false, byName: '', reason: '', sinceMs: 0, dropped: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.recordsPerSecond = r.double(); break;
      case 16: m.byPolicy = r.bool(); break;
      case 26: m.byName = r.string(); break;
      case 34: m.reason = r.string(); break;
      case 41: m.sinceMs = r.double(); break;
      case 49: m.dropped = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeClientThrottleRequest(m: Init<T.ClientThrottleRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.targetId != null) w.string(18, m.targetId);
  if (m.recordsPerSecond != null) w.double(25, m.recordsPerSecond);
  if (m.reason != null) w.string(34, m.reason);
}

export function decodeClientThrottleRequest(r: Reader, into?: T.ClientThrottleRequest): T.ClientThrottleRequest {
  const m: T.ClientThrottleRequest = into ?? { clientId: '', targetId: '', recordsPerSecond: 0, reason: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.targetId = r.string(); break;
      case 25: m.recordsPerSecond = r.double(); break;
      case 34: m.reason = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeEndedTopics(m: Init<T.EndedTopics>, w: Writer): void {
  if (m.topics != null) for (const e of m.topics) w.string(10, e);
}

export function decodeEndedTopics(r: Reader, into?: T.EndedTopics): T.EndedTopics {
  const m: T.EndedTopics = into ?? { topics: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topics.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeFlightRecorder(m: Init<T.FlightRecorder>, w: Writer): void {
  if (m.isOn != null) w.bool(8, m.isOn);
  if (m.minutes != null) w.double(17, m.minutes);
  if (m.maxBytes != null) w.double(25, m.maxBytes);
  if (m.withImages != null) w.bool(32, m.withImages);
  if (m.heldMs != null) w.double(41, m.heldMs);
  if (m.heldBytes != null) w.double(49, m.heldBytes);
  if (m.topicCount != null) w.int32(56, m.topicCount);
  if (m.recordCount != null) w.double(65, m.recordCount);
  if (m.recordsPerSecond != null && m.recordsPerSecond.length > 0) w.doubles(74, m.recordsPerSecond);
  if (m.lostCount != null) w.double(81, m.lostCount);
}

export function decodeFlightRecorder(r: Reader, into?: T.FlightRecorder): T.FlightRecorder {
  const m: T.FlightRecorder = into ?? { isOn: false, minutes: 0, maxBytes: 0, withImages: false, heldMs: 0, heldBytes: 0, topicCount: 0, recordCount: 0, recordsPerSecond: [], lostCount: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.isOn = r.bool(); break;
      case 17: m.minutes = r.double(); break;
      case 25: m.maxBytes = r.double(); break;
      case 32: m.withImages = r.bool(); break;
      case 41: m.heldMs = r.double(); break;
      case 49: m.heldBytes = r.double(); break;
      case 56: m.topicCount = r.int32(); break;
      case 65: m.recordCount = r.double(); break;
      case 73: m.recordsPerSecond.push(r.double()); break;
      case 74: r.doubles(m.recordsPerSecond); break;
      case 81: m.lostCount = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeFlightRecorderKeepRequest(m: Init<T.FlightRecorderKeepRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.name != null) w.string(18, m.name);
  if (m.notes != null) w.string(26, m.notes);
}

export function decodeFlightRecorderKeepRequest(r: Reader, into?: T.FlightRecorderKeepRequest): T.FlightRecorderKeepRequest {
  const m: T.FlightRecorderKeepRequest = into ?? { clientId: '', name: '', notes: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.notes = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeFlightRecorderSettings(m: Init<T.FlightRecorderSettings>, w: Writer): void {
  if (m.isOn != null) w.bool(8, m.isOn);
  if (m.minutes != null) w.double(17, m.minutes);
  if (m.maxBytes != null) w.double(25, m.maxBytes);
  if (m.withImages != null) w.bool(32, m.withImages);
}

export function decodeFlightRecorderSettings(r: Reader, into?: T.FlightRecorderSettings): T.FlightRecorderSettings {
  const m: T.FlightRecorderSettings = into ?? { isOn: false, minutes: 0, maxBytes: 0, withImages: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.isOn = r.bool(); break;
      case 17: m.minutes = r.double(); break;
      case 25: m.maxBytes = r.double(); break;
      case 32: m.withImages = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeJoinCheck(m: Init<T.JoinCheck>, w: Writer): void {
  if (m.role != null) w.int32(8, m.role);
  if (m.problem != null) w.int32(16, m.problem);
  if (m.message != null) w.string(26, m.message);
  if (m.target != null) w.string(34, m.target);
  if (m.expiresMs != null) w.double(41, m.expiresMs);
  if (m.masterName != null) w.string(50, m.masterName);
  if (m.isJoined != null) w.bool(56, m.isJoined);
}

export function decodeJoinCheck(r: Reader, into?: T.JoinCheck): T.JoinCheck {
  const m: T.JoinCheck = into ?? { role: 0, problem: 0, message: '', target: '', expiresMs: 0, masterName: '', isJoined: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.role = r.int32() as T.AccessRole; break;
      case 16: m.problem = r.int32() as T.JoinProblem; break;
      case 26: m.message = r.string(); break;
      case 34: m.target = r.string(); break;
      case 41: m.expiresMs = r.double(); break;
      case 50: m.masterName = r.string(); break;
      case 56: m.isJoined = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeJoinCheckRequest(m: Init<T.JoinCheckRequest>, w: Writer): void {
  if (m.token != null) w.string(10, m.token);
}

export function decodeJoinCheckRequest(r: Reader, into?: T.JoinCheckRequest): T.JoinCheckRequest {
  const m: T.JoinCheckRequest = into ?? { token: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.token = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeJoinRefusal(m: Init<T.JoinRefusal>, w: Writer): void {
  if (m.problem != null) w.int32(8, m.problem);
}

export function decodeJoinRefusal(r: Reader, into?: T.JoinRefusal): T.JoinRefusal {
  const m: T.JoinRefusal = into ?? { problem: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.problem = r.int32() as T.JoinProblem; break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLimit(m: Init<T.Limit>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
  if (m.value != null) w.double(17, m.value);
  if (m.unit != null) w.string(26, m.unit);
  if (m.reason != null) w.string(34, m.reason);
  if (m.group != null) w.string(42, m.group);
  if (m.use != null) { const at = w.open(50); encodeLimitUse(m.use, w); w.close(at); }
  if (m.hits != null) w.double(57, m.hits);
}

export function decodeLimit(r: Reader, into?: T.Limit): T.Limit {
  const m: T.Limit = into ?? { name: '', value: 0, unit: '', reason: '', group: '', use: undefined, hits: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      case 17: m.value = r.double(); break;
      case 26: m.unit = r.string(); break;
      case 34: m.reason = r.string(); break;
      case 42: m.group = r.string(); break;
      case 50: { const end = r.enter(); m.use = decodeLimitUse(r, m.use); r.end = end; break; }
      case 57: m.hits = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLimitList(m: Init<T.LimitList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeLimit(e, w); w.close(at); }
}

export function decodeLimitList(r: Reader, into?: T.LimitList): T.LimitList {
  const m: T.LimitList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeLimit(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLimitUse(m: Init<T.LimitUse>, w: Writer): void {
  if (m.value != null) w.double(9, m.value);
  if (m.clientId != null) w.string(18, m.clientId);
  if (m.sessionId != null) w.string(26, m.sessionId);
}

export function decodeLimitUse(r: Reader, into?: T.LimitUse): T.LimitUse {
  const m: T.LimitUse = into ?? { value: 0, clientId: '', sessionId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.value = r.double(); break;
      case 18: m.clientId = r.string(); break;
      case 26: m.sessionId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLogField(m: Init<T.LogField>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
  if (m.value != null) w.string(18, m.value);
}

export function decodeLogField(r: Reader, into?: T.LogField): T.LogField {
  const m: T.LogField = into ?? { name: '', value: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      case 18: m.value = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLogLine(m: Init<T.LogLine>, w: Writer): void {
  if (m.number != null) w.double(9, m.number);
  if (m.timeMs != null) w.double(17, m.timeMs);
  if (m.level != null) w.int32(24, m.level);
  if (m.message != null) w.string(34, m.message);
  if (m.fields != null) for (const e of m.fields) { const at = w.open(42); encodeLogField(e, w); w.close(at); }
}

export function decodeLogLine(r: Reader, into?: T.LogLine): T.LogLine {
  const m: T.LogLine = into ?? { number: 0, timeMs: 0, level: 0, message: '', fields: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.number = r.double(); break;
      case 17: m.timeMs = r.double(); break;
      case 24: m.level = r.int32() as T.LogLevel; break;
      case 34: m.message = r.string(); break;
      case 42: { const end = r.enter(); m.fields.push(decodeLogField(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLogRequest(m: Init<T.LogRequest>, w: Writer): void {
  if (m.cursor != null) w.double(9, m.cursor);
  if (m.level != null) w.int32(16, m.level);
  if (m.count != null) w.int32(24, m.count);
}

export function decodeLogRequest(r: Reader, into?: T.LogRequest): T.LogRequest {
  const m: T.LogRequest = into ?? { cursor: 0, level: 0, count: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.cursor = r.double(); break;
      case 16: m.level = r.int32() as T.LogLevel; break;
      case 24: m.count = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLogTail(m: Init<T.LogTail>, w: Writer): void {
  if (m.cursor != null) w.double(9, m.cursor);
  if (m.reset != null) w.bool(16, m.reset);
  if (m.missed != null) w.double(25, m.missed);
  if (m.lines != null) for (const e of m.lines) { const at = w.open(34); encodeLogLine(e, w); w.close(at); }
}

export function decodeLogTail(r: Reader, into?: T.LogTail): T.LogTail {
  const m: T.LogTail = into ?? { cursor: 0, reset: false, missed: 0, lines: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.cursor = r.double(); break;
      case 16: m.reset = r.bool(); break;
      case 25: m.missed = r.double(); break;
      case 34: { const end = r.enter(); m.lines.push(decodeLogLine(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMasterAddress(m: Init<T.MasterAddress>, w: Writer): void {
  if (m.kind != null) w.int32(8, m.kind);
  if (m.interfaceName != null) w.string(18, m.interfaceName);
  if (m.url != null) w.string(26, m.url);
}

export function decodeMasterAddress(r: Reader, into?: T.MasterAddress): T.MasterAddress {
  const m: T.MasterAddress = into ?? { kind: 0, interfaceName: '', url: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.kind = r.int32() as T.MasterAddressKind; break;
      case 18: m.interfaceName = r.string(); break;
      case 26: m.url = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMasterStatus(m: Init<T.MasterStatus>, w: Writer): void {
  if (m.masterId != null) w.string(10, m.masterId);
  if (m.name != null) w.string(18, m.name);
  if (m.version != null) w.string(26, m.version);
  if (m.startedMs != null) w.double(33, m.startedMs);
  if (m.nowMs != null) w.double(41, m.nowMs);
  if (m.recordsIn != null) w.double(49, m.recordsIn);
  if (m.recordsOut != null) w.double(57, m.recordsOut);
  if (m.bytesIn != null) w.double(65, m.bytesIn);
  if (m.bytesOut != null) w.double(73, m.bytesOut);
  if (m.dropped != null) w.double(81, m.dropped);
  if (m.refused != null) w.double(89, m.refused);
  if (m.topics != null) w.int32(96, m.topics);
  if (m.clientsActive != null) w.int32(104, m.clientsActive);
  if (m.clientsInactive != null) w.int32(112, m.clientsInactive);
  if (m.clientsUnavailable != null) w.int32(120, m.clientsUnavailable);
  if (m.cpuPercent != null) w.float(133, m.cpuPercent);
  if (m.memoryBytes != null) w.double(137, m.memoryBytes);
  if (m.samples != null) for (const e of m.samples) { const at = w.open(146); encodeStatusSample(e, w); w.close(at); }
  if (m.events != null) for (const e of m.events) { const at = w.open(154); encodeStatusEvent(e, w); w.close(at); }
  if (m.problems != null) for (const e of m.problems) { const at = w.open(162); encodeStatusProblem(e, w); w.close(at); }
  if (m.addresses != null) for (const e of m.addresses) { const at = w.open(170); encodeMasterAddress(e, w); w.close(at); }
  if (m.busyPercent != null) w.double(177, m.busyPercent);
  if (m.delayMs != null) w.double(185, m.delayMs);
  if (m.processors != null) w.int32(192, m.processors);
}

export function decodeMasterStatus(r: Reader, into?: T.MasterStatus): T.MasterStatus {
  const m: T.MasterStatus = into ?? { masterId: '', name: '', version: '', startedMs: 0, nowMs: 0, recordsIn: 0, recordsOut: 0, bytesIn: 0, bytesOut: 0, dropped: 0, refused: 0, topics: 0, clientsActive: 0, clientsInactive: 0, clientsUnavailable: 0, cpuPercent: 0, memoryBytes: 0, samples: [], events: [], problems: [], addresses: [], busyPercent: 0, delayMs: 0, processors: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.masterId = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.version = r.string(); break;
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
      case 146: { const end = r.enter(); m.samples.push(decodeStatusSample(r)); r.end = end; break; }
      case 154: { const end = r.enter(); m.events.push(decodeStatusEvent(r)); r.end = end; break; }
      case 162: { const end = r.enter(); m.problems.push(decodeStatusProblem(r)); r.end = end; break; }
      case 170: { const end = r.enter(); m.addresses.push(decodeMasterAddress(r)); r.end = end; break; }
      case 177: m.busyPercent = r.double(); break;
      case 185: m.delayMs = r.double(); break;
      case 192: m.processors = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeMasterStatusRequest(m: Init<T.MasterStatusRequest>, w: Writer): void {
  if (m.sinceMs != null) w.double(9, m.sinceMs);
}

export function decodeMasterStatusRequest(r: Reader, into?: T.MasterStatusRequest): T.MasterStatusRequest {
  const m: T.MasterStatusRequest = into ?? { sinceMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.sinceMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleEvent(m: Init<T.ModuleEvent>, w: Writer): void {
  if (m.sessionId != null) w.string(10, m.sessionId);
  if (m.moduleId != null) w.string(18, m.moduleId);
  if (m.moduleName != null) w.string(26, m.moduleName);
  if (m.nodeId != null) w.string(34, m.nodeId);
  if (m.kind != null) w.int32(40, m.kind);
  if (m.timeMs != null) w.double(49, m.timeMs);
  if (m.phase != null) w.string(58, m.phase);
  if (m.message != null) w.string(66, m.message);
  if (m.line != null) w.int32(72, m.line);
  if (m.column != null) w.int32(80, m.column);
  if (m.level != null) w.string(90, m.level);
  if (m.suppressed != null) w.int32(96, m.suppressed);
}

export function decodeModuleEvent(r: Reader, into?: T.ModuleEvent): T.ModuleEvent {
  const m: T.ModuleEvent = into ?? { sessionId: '', moduleId: '', moduleName: '', nodeId: '', kind: 0, timeMs: 0, phase: '', message: '', line: 0, column: 0, level: '', suppressed: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.sessionId = r.string(); break;
      case 18: m.moduleId = r.string(); break;
      case 26: m.moduleName = r.string(); break;
      case 34: m.nodeId = r.string(); break;
      case 40: m.kind = r.int32() as T.ModuleEventKind; break;
      case 49: m.timeMs = r.double(); break;
      case 58: m.phase = r.string(); break;
      case 66: m.message = r.string(); break;
      case 72: m.line = r.int32(); break;
      case 80: m.column = r.int32(); break;
      case 90: m.level = r.string(); break;
      case 96: m.suppressed = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleExtension(m: Init<T.ModuleExtension>, w: Writer): void {
  if (m.version != null) w.string(10, m.version);
  if (m.libraries != null) for (const e of m.libraries) w.string(18, e);
  if (m.replaceable != null) w.bool(24, m.replaceable);
  if (m.origin != null) w.int32(32, m.origin);
  if (m.grantIds != null) for (const e of m.grantIds) w.string(42, e);
  if (m.assets != null) for (const e of m.assets) w.string(50, e);
  if (m.optionalAssets != null) for (const e of m.optionalAssets) w.string(58, e);
}

export function decodeModuleExtension(r: Reader, into?: T.ModuleExtension): T.ModuleExtension {
  const m: T.ModuleExtension = into ?? { version: '', libraries: [], replaceable: false, origin: 0, grantIds: [], assets: [], optionalAssets: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.version = r.string(); break;
      case 18: m.libraries.push(r.string()); break;
      case 24: m.replaceable = r.bool(); break;
      case 32: m.origin = r.int32() as T.ModuleOrigin; break;
      case 42: m.grantIds.push(r.string()); break;
      case 50: m.assets.push(r.string()); break;
      case 58: m.optionalAssets.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleReports(m: Init<T.ModuleReports>, w: Writer): void {
  if (m.statistics != null) for (const e of m.statistics) { const at = w.open(10); encodeModuleStatistics(e, w); w.close(at); }
  if (m.events != null) for (const e of m.events) { const at = w.open(18); encodeModuleEvent(e, w); w.close(at); }
}

export function decodeModuleReports(r: Reader, into?: T.ModuleReports): T.ModuleReports {
  const m: T.ModuleReports = into ?? { statistics: [], events: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.statistics.push(decodeModuleStatistics(r)); r.end = end; break; }
      case 18: { const end = r.enter(); m.events.push(decodeModuleEvent(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleStatistics(m: Init<T.ModuleStatistics>, w: Writer): void {
  if (m.moduleId != null) w.string(10, m.moduleId);
  if (m.moduleName != null) w.string(18, m.moduleName);
  if (m.nodeId != null) w.string(26, m.nodeId);
  if (m.status != null) w.int32(32, m.status);
  if (m.runs != null) w.double(41, m.runs);
  if (m.runsPerSecond != null) w.double(49, m.runsPerSecond);
  if (m.runP50Ms != null) w.double(57, m.runP50Ms);
  if (m.runP95Ms != null) w.double(65, m.runP95Ms);
  if (m.overruns != null) w.double(73, m.overruns);
  if (m.errors != null) w.double(81, m.errors);
  if (m.restarts != null) w.double(89, m.restarts);
  if (m.outputs != null) w.double(97, m.outputs);
  if (m.outputsRefused != null) w.double(105, m.outputsRefused);
  if (m.waiting != null) w.int32(112, m.waiting);
  if (m.topics != null) w.int32(120, m.topics);
  if (m.topicsRefused != null) w.double(129, m.topicsRefused);
  if (m.refusedOutput != null) w.string(138, m.refusedOutput);
  if (m.memoryBytes != null) w.double(145, m.memoryBytes);
  if (m.loadingSet != null) w.string(154, m.loadingSet);
  if (m.loadedBytes != null) w.double(161, m.loadedBytes);
  if (m.loadingBytes != null) w.double(169, m.loadingBytes);
}

export function decodeModuleStatistics(r: Reader, into?: T.ModuleStatistics): T.ModuleStatistics {
  const m: T.ModuleStatistics = into ?? { moduleId: '', moduleName: '', nodeId: '', status: 0, runs: 0, runsPerSecond: 0, runP50Ms: 0, runP95Ms: 0, overruns: 0, errors: 0, restarts: 0, outputs: 0, outputsRefused: 0, waiting: 0, topics: 0, topicsRefused: 0, refusedOutput: '', memoryBytes: 0, loadingSet: '', loadedBytes: 0, loadingBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.moduleId = r.string(); break;
      case 18: m.moduleName = r.string(); break;
      case 26: m.nodeId = r.string(); break;
      case 32: m.status = r.int32() as T.ProcessingModuleStatus; break;
      case 41: m.runs = r.double(); break;
      case 49: m.runsPerSecond = r.double(); break;
      case 57: m.runP50Ms = r.double(); break;
      case 65: m.runP95Ms = r.double(); break;
      case 73: m.overruns = r.double(); break;
      case 81: m.errors = r.double(); break;
      case 89: m.restarts = r.double(); break;
      case 97: m.outputs = r.double(); break;
      case 105: m.outputsRefused = r.double(); break;
      case 112: m.waiting = r.int32(); break;
      case 120: m.topics = r.int32(); break;
      case 129: m.topicsRefused = r.double(); break;
      case 138: m.refusedOutput = r.string(); break;
      case 145: m.memoryBytes = r.double(); break;
      case 154: m.loadingSet = r.string(); break;
      case 161: m.loadedBytes = r.double(); break;
      case 169: m.loadingBytes = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleVersion(m: Init<T.ModuleVersion>, w: Writer): void {
  if (m.number != null) w.int32(8, m.number);
  if (m.timeMs != null) w.double(17, m.timeMs);
  if (m.origin != null) w.int32(24, m.origin);
  if (m.version != null) w.string(34, m.version);
  if (m.byteLength != null) w.int32(40, m.byteLength);
  if (m.current != null) w.bool(48, m.current);
  if (m.module != null) { const at = w.open(58); encodeProcessingModule(m.module, w); w.close(at); }
}

export function decodeModuleVersion(r: Reader, into?: T.ModuleVersion): T.ModuleVersion {
  const m: T.ModuleVersion = into ?? { number: 0, timeMs: 0, origin: 0, version: '', byteLength: 0, current: false, module: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.number = r.int32(); break;
      case 17: m.timeMs = r.double(); break;
      case 24: m.origin = r.int32() as T.ModuleVersionOrigin; break;
      case 34: m.version = r.string(); break;
      case 40: m.byteLength = r.int32(); break;
      case 48: m.current = r.bool(); break;
      case 58: { const end = r.enter(); m.module = decodeProcessingModule(r, m.module); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleVersionList(m: Init<T.ModuleVersionList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeModuleVersion(e, w); w.close(at); }
}

export function decodeModuleVersionList(r: Reader, into?: T.ModuleVersionList): T.ModuleVersionList {
  const m: T.ModuleVersionList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeModuleVersion(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleVersionRequest(m: Init<T.ModuleVersionRequest>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
  if (m.moduleId != null) w.string(18, m.moduleId);
  if (m.number != null) w.int32(24, m.number);
}

export function decodeModuleVersionRequest(r: Reader, into?: T.ModuleVersionRequest): T.ModuleVersionRequest {
  const m: T.ModuleVersionRequest = into ?? { name: '', moduleId: '', number: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      case 18: m.moduleId = r.string(); break;
      case 24: m.number = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeExtension(m: Init<T.NodeExtension>, w: Writer): void {
  if (m.kind != null) w.int32(8, m.kind);
  if (m.runsJavascript != null) w.bool(16, m.runsJavascript);
  if (m.acceptsWork != null) w.bool(24, m.acceptsWork);
  if (m.libraries != null) for (const e of m.libraries) w.string(34, e);
  if (m.capacity != null) w.int32(40, m.capacity);
  if (m.memoryBytes != null) w.double(49, m.memoryBytes);
  if (m.loadsAssets != null) w.bool(56, m.loadsAssets);
}

export function decodeNodeExtension(r: Reader, into?: T.NodeExtension): T.NodeExtension {
  const m: T.NodeExtension = into ?? { kind: 0, runsJavascript: false, acceptsWork: false, libraries: [], capacity: 0, memoryBytes: 0, loadsAssets: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.kind = r.int32() as T.NodeExtensionKind; break;
      case 16: m.runsJavascript = r.bool(); break;
      case 24: m.acceptsWork = r.bool(); break;
      case 34: m.libraries.push(r.string()); break;
      case 40: m.capacity = r.int32(); break;
      case 49: m.memoryBytes = r.double(); break;
      case 56: m.loadsAssets = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeInfo(m: Init<T.NodeInfo>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.name != null) w.string(18, m.name);
  if (m.node != null) { const at = w.open(26); encodeNodeExtension(m.node, w); w.close(at); }
  if (m.moduleNames != null) for (const e of m.moduleNames) w.string(34, e);
  if (m.instances != null) w.int32(40, m.instances);
  if (m.available != null) w.bool(48, m.available);
  if (m.dedicated != null) w.bool(56, m.dedicated);
  if (m.memoryBytes != null) w.double(65, m.memoryBytes);
}

export function decodeNodeInfo(r: Reader, into?: T.NodeInfo): T.NodeInfo {
  const m: T.NodeInfo = into ?? { clientId: '', name: '', node: undefined, moduleNames: [], instances: 0, available: false, dedicated: false, memoryBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: { const end = r.enter(); m.node = decodeNodeExtension(r, m.node); r.end = end; break; }
      case 34: m.moduleNames.push(r.string()); break;
      case 40: m.instances = r.int32(); break;
      case 48: m.available = r.bool(); break;
      case 56: m.dedicated = r.bool(); break;
      case 65: m.memoryBytes = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeList(m: Init<T.NodeList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeNodeInfo(e, w); w.close(at); }
}

export function decodeNodeList(r: Reader, into?: T.NodeList): T.NodeList {
  const m: T.NodeList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeNodeInfo(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeMessage(m: Init<T.NodeMessage>, w: Writer): void {
  if (m.lockstepRequest != null) { const at = w.open(10); encodeLockstepProcessingRequest(m.lockstepRequest, w); w.close(at); }
  if (m.lockstepReply != null) { const at = w.open(18); encodeLockstepProcessingReply(m.lockstepReply, w); w.close(at); }
  if (m.moduleReports != null) { const at = w.open(26); encodeModuleReports(m.moduleReports, w); w.close(at); }
  if (m.endedTopics != null) { const at = w.open(34); encodeEndedTopics(m.endedTopics, w); w.close(at); }
}

const NodeMessage_type = ['lockstepRequest', 'lockstepReply', 'moduleReports', 'endedTopics'] as const;
export function decodeNodeMessage(r: Reader, into?: T.NodeMessage): T.NodeMessage {
  const m: T.NodeMessage = into ?? {};
  let type = into && setMember(into, NodeMessage_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: type = only(m, type, 'lockstepRequest'); { const end = r.enter(); m.lockstepRequest = decodeLockstepProcessingRequest(r, m.lockstepRequest); r.end = end; break; }
      case 18: type = only(m, type, 'lockstepReply'); { const end = r.enter(); m.lockstepReply = decodeLockstepProcessingReply(r, m.lockstepReply); r.end = end; break; }
      case 26: type = only(m, type, 'moduleReports'); { const end = r.enter(); m.moduleReports = decodeModuleReports(r, m.moduleReports); r.end = end; break; }
      case 34: type = only(m, type, 'endedTopics'); { const end = r.enter(); m.endedTopics = decodeEndedTopics(r, m.endedTopics); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordExtension(m: Init<T.RecordExtension>, w: Writer): void {
  if (m.keepSeconds != null) w.int32(8, m.keepSeconds);
  if (m.expiryMs != null) w.int32(16, m.expiryMs);
}

export function decodeRecordExtension(r: Reader, into?: T.RecordExtension): T.RecordExtension {
  const m: T.RecordExtension = into ?? { keepSeconds: 0, expiryMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.keepSeconds = r.int32(); break;
      case 16: m.expiryMs = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecording(m: Init<T.Recording>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.kind != null) w.int32(24, m.kind);
  if (m.state != null) w.int32(32, m.state);
  if (m.startedMs != null) w.double(41, m.startedMs);
  if (m.durationMs != null) w.double(49, m.durationMs);
  if (m.sizeBytes != null) w.double(57, m.sizeBytes);
  if (m.recordCount != null) w.double(65, m.recordCount);
  if (m.lostCount != null) w.double(73, m.lostCount);
  if (m.topicCount != null) w.int32(80, m.topicCount);
  if (m.markerCount != null) w.int32(88, m.markerCount);
  if (m.problem != null) w.string(98, m.problem);
  if (m.notes != null) w.string(106, m.notes);
  if (m.author != null) w.string(114, m.author);
  if (m.selection != null) { const at = w.open(122); encodeRecordingSelection(m.selection, w); w.close(at); }
  if (m.budget != null) { const at = w.open(130); encodeRecordingBudget(m.budget, w); w.close(at); }
  if (m.topics != null) for (const e of m.topics) { const at = w.open(138); encodeRecordingTopic(e, w); w.close(at); }
  if (m.markers != null) for (const e of m.markers) { const at = w.open(146); encodeRecordingMarker(e, w); w.close(at); }
}

export function decodeRecording(r: Reader, into?: T.Recording): T.Recording {
  const m: T.Recording = into ?? { id: '', name: '', kind: 0, state: 0, startedMs: 0, durationMs: 0, sizeBytes: 0, recordCount: 0, lostCount: 0, topicCount: 0, markerCount: 0, problem: '', notes: '', author: '', selection: undefined, budget: undefined, topics: [], markers: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 24: m.kind = r.int32() as T.RecordingKind; break;
      case 32: m.state = r.int32() as T.RecordingState; break;
      case 41: m.startedMs = r.double(); break;
      case 49: m.durationMs = r.double(); break;
      case 57: m.sizeBytes = r.double(); break;
      case 65: m.recordCount = r.double(); break;
      case 73: m.lostCount = r.double(); break;
      case 80: m.topicCount = r.int32(); break;
      case 88: m.markerCount = r.int32(); break;
      case 98: m.problem = r.string(); break;
      case 106: m.notes = r.string(); break;
      case 114: m.author = r.string(); break;
      case 122: { const end = r.enter(); m.selection = decodeRecordingSelection(r, m.selection); r.end = end; break; }
      case 130: { const end = r.enter(); m.budget = decodeRecordingBudget(r, m.budget); r.end = end; break; }
      case 138: { const end = r.enter(); m.topics.push(decodeRecordingTopic(r)); r.end = end; break; }
      case 146: { const end = r.enter(); m.markers.push(decodeRecordingMarker(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingBudget(m: Init<T.RecordingBudget>, w: Writer): void {
  if (m.maxDurationMs != null) w.double(9, m.maxDurationMs);
  if (m.maxBytes != null) w.double(17, m.maxBytes);
  if (m.minFreeBytes != null) w.double(25, m.minFreeBytes);
}

export function decodeRecordingBudget(r: Reader, into?: T.RecordingBudget): T.RecordingBudget {
  const m: T.RecordingBudget = into ?? { maxDurationMs: 0, maxBytes: 0, minFreeBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.maxDurationMs = r.double(); break;
      case 17: m.maxBytes = r.double(); break;
      case 25: m.minFreeBytes = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingChangeRequest(m: Init<T.RecordingChangeRequest>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.notes != null) w.string(26, m.notes);
}

export function decodeRecordingChangeRequest(r: Reader, into?: T.RecordingChangeRequest): T.RecordingChangeRequest {
  const m: T.RecordingChangeRequest = into ?? { id: '', name: '', notes: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.notes = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingEstimate(m: Init<T.RecordingEstimate>, w: Writer): void {
  if (m.topics != null) for (const e of m.topics) { const at = w.open(10); encodeRecordingTopicRate(e, w); w.close(at); }
  if (m.recordsPerSecond != null) w.double(17, m.recordsPerSecond);
  if (m.bytesPerSecond != null) w.double(25, m.bytesPerSecond);
  if (m.freeBytes != null) w.double(33, m.freeBytes);
}

export function decodeRecordingEstimate(r: Reader, into?: T.RecordingEstimate): T.RecordingEstimate {
  const m: T.RecordingEstimate = into ?? { topics: [], recordsPerSecond: 0, bytesPerSecond: 0, freeBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.topics.push(decodeRecordingTopicRate(r)); r.end = end; break; }
      case 17: m.recordsPerSecond = r.double(); break;
      case 25: m.bytesPerSecond = r.double(); break;
      case 33: m.freeBytes = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingList(m: Init<T.RecordingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeRecording(e, w); w.close(at); }
  if (m.sizeBytes != null) w.double(17, m.sizeBytes);
  if (m.maxBytes != null) w.double(25, m.maxBytes);
  if (m.freeBytes != null) w.double(33, m.freeBytes);
}

export function decodeRecordingList(r: Reader, into?: T.RecordingList): T.RecordingList {
  const m: T.RecordingList = into ?? { elements: [], sizeBytes: 0, maxBytes: 0, freeBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeRecording(r)); r.end = end; break; }
      case 17: m.sizeBytes = r.double(); break;
      case 25: m.maxBytes = r.double(); break;
      case 33: m.freeBytes = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingMarker(m: Init<T.RecordingMarker>, w: Writer): void {
  if (m.recordingId != null) w.string(10, m.recordingId);
  if (m.id != null) w.string(18, m.id);
  if (m.timeMs != null) w.double(25, m.timeMs);
  if (m.text != null) w.string(34, m.text);
  if (m.author != null) w.string(42, m.author);
  if (m.clientId != null) w.string(50, m.clientId);
  if (m.isRemoved != null) w.bool(56, m.isRemoved);
}

export function decodeRecordingMarker(r: Reader, into?: T.RecordingMarker): T.RecordingMarker {
  const m: T.RecordingMarker = into ?? { recordingId: '', id: '', timeMs: 0, text: '', author: '', clientId: '', isRemoved: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.recordingId = r.string(); break;
      case 18: m.id = r.string(); break;
      case 25: m.timeMs = r.double(); break;
      case 34: m.text = r.string(); break;
      case 42: m.author = r.string(); break;
      case 50: m.clientId = r.string(); break;
      case 56: m.isRemoved = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingRequest(m: Init<T.RecordingRequest>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
}

export function decodeRecordingRequest(r: Reader, into?: T.RecordingRequest): T.RecordingRequest {
  const m: T.RecordingRequest = into ?? { id: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingSelection(m: Init<T.RecordingSelection>, w: Writer): void {
  if (m.topics != null) for (const e of m.topics) w.string(10, e);
  if (m.patterns != null) for (const e of m.patterns) w.string(18, e);
  if (m.clients != null) for (const e of m.clients) w.string(26, e);
  if (m.devices != null) for (const e of m.devices) w.string(34, e);
  if (m.sessions != null) for (const e of m.sessions) w.string(42, e);
  if (m.excludedPatterns != null) for (const e of m.excludedPatterns) w.string(50, e);
  if (m.withoutImages != null) w.bool(56, m.withoutImages);
}

export function decodeRecordingSelection(r: Reader, into?: T.RecordingSelection): T.RecordingSelection {
  const m: T.RecordingSelection = into ?? { topics: [], patterns: [], clients: [], devices: [], sessions: [], excludedPatterns: [], withoutImages: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topics.push(r.string()); break;
      case 18: m.patterns.push(r.string()); break;
      case 26: m.clients.push(r.string()); break;
      case 34: m.devices.push(r.string()); break;
      case 42: m.sessions.push(r.string()); break;
      case 50: m.excludedPatterns.push(r.string()); break;
      case 56: m.withoutImages = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingStartRequest(m: Init<T.RecordingStartRequest>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.name != null) w.string(18, m.name);
  if (m.notes != null) w.string(26, m.notes);
  if (m.selection != null) { const at = w.open(34); encodeRecordingSelection(m.selection, w); w.close(at); }
  if (m.budget != null) { const at = w.open(42); encodeRecordingBudget(m.budget, w); w.close(at); }
}

export function decodeRecordingStartRequest(r: Reader, into?: T.RecordingStartRequest): T.RecordingStartRequest {
  const m: T.RecordingStartRequest = into ?? { clientId: '', name: '', notes: '', selection: undefined, budget: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.notes = r.string(); break;
      case 34: { const end = r.enter(); m.selection = decodeRecordingSelection(r, m.selection); r.end = end; break; }
      case 42: { const end = r.enter(); m.budget = decodeRecordingBudget(r, m.budget); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingStatus(m: Init<T.RecordingStatus>, w: Writer): void {
  if (m.running != null) for (const e of m.running) { const at = w.open(10); encodeRecording(e, w); w.close(at); }
  if (m.flightRecorder != null) { const at = w.open(18); encodeFlightRecorder(m.flightRecorder, w); w.close(at); }
  if (m.listRevision != null) w.int32(24, m.listRevision);
}

export function decodeRecordingStatus(r: Reader, into?: T.RecordingStatus): T.RecordingStatus {
  const m: T.RecordingStatus = into ?? { running: [], flightRecorder: undefined, listRevision: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.running.push(decodeRecording(r)); r.end = end; break; }
      case 18: { const end = r.enter(); m.flightRecorder = decodeFlightRecorder(r, m.flightRecorder); r.end = end; break; }
      case 24: m.listRevision = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingTopic(m: Init<T.RecordingTopic>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.clientId != null) w.string(18, m.clientId);
  if (m.clientName != null) w.string(26, m.clientName);
  if (m.dataFormat != null) w.string(34, m.dataFormat);
  if (m.recordCount != null) w.double(41, m.recordCount);
}

export function decodeRecordingTopic(r: Reader, into?: T.RecordingTopic): T.RecordingTopic {
  const m: T.RecordingTopic = into ?? { topic: '', clientId: '', clientName: '', dataFormat: '', recordCount: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.clientId = r.string(); break;
      case 26: m.clientName = r.string(); break;
      case 34: m.dataFormat = r.string(); break;
      case 41: m.recordCount = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeRecordingTopicRate(m: Init<T.RecordingTopicRate>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.dataFormat != null) w.string(18, m.dataFormat);
  if (m.recordsPerSecond != null) w.double(25, m.recordsPerSecond);
  if (m.bytesPerSecond != null) w.double(33, m.bytesPerSecond);
}

export function decodeRecordingTopicRate(r: Reader, into?: T.RecordingTopicRate): T.RecordingTopicRate {
  const m: T.RecordingTopicRate = into ?? { topic: '', dataFormat: '', recordsPerSecond: 0, bytesPerSecond: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.dataFormat = r.string(); break;
      case 25: m.recordsPerSecond = r.double(); break;
      case 33: m.bytesPerSecond = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSessionExtension(m: Init<T.SessionExtension>, w: Writer): void {
  if (m.state != null) w.int32(8, m.state);
  if (m.problems != null) for (const e of m.problems) { const at = w.open(18); encodeSessionProblem(e, w); w.close(at); }
  if (m.startWithMaster != null) w.bool(24, m.startWithMaster);
  if (m.lockstepHertz != null) w.double(33, m.lockstepHertz);
  if (m.editorJson != null) w.string(42, m.editorJson);
  if (m.revision != null) w.int32(48, m.revision);
  if (m.stored != null) w.bool(56, m.stored);
  if (m.grantIds != null) for (const e of m.grantIds) w.string(66, e);
}

export function decodeSessionExtension(r: Reader, into?: T.SessionExtension): T.SessionExtension {
  const m: T.SessionExtension = into ?? { state: 0, problems: [], startWithMaster: false, lockstepHertz: 0, editorJson: '', revision: 0, stored: false, grantIds: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.state = r.int32() as T.SessionState; break;
      case 18: { const end = r.enter(); m.problems.push(decodeSessionProblem(r)); r.end = end; break; }
      case 24: m.startWithMaster = r.bool(); break;
      case 33: m.lockstepHertz = r.double(); break;
      case 42: m.editorJson = r.string(); break;
      case 48: m.revision = r.int32(); break;
      case 56: m.stored = r.bool(); break;
      case 66: m.grantIds.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSessionProblem(m: Init<T.SessionProblem>, w: Writer): void {
  if (m.isError != null) w.bool(8, m.isError);
  if (m.code != null) w.string(18, m.code);
  if (m.message != null) w.string(26, m.message);
  if (m.path != null) w.string(34, m.path);
  if (m.moduleId != null) w.string(42, m.moduleId);
  if (m.moduleName != null) w.string(50, m.moduleName);
  if (m.nodeId != null) w.string(58, m.nodeId);
  if (m.line != null) w.int32(64, m.line);
  if (m.column != null) w.int32(72, m.column);
}

export function decodeSessionProblem(r: Reader, into?: T.SessionProblem): T.SessionProblem {
  const m: T.SessionProblem = into ?? { isError: false, code: '', message: '', path: '', moduleId: '', moduleName: '', nodeId: '', line: 0, column: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.isError = r.bool(); break;
      case 18: m.code = r.string(); break;
      case 26: m.message = r.string(); break;
      case 34: m.path = r.string(); break;
      case 42: m.moduleId = r.string(); break;
      case 50: m.moduleName = r.string(); break;
      case 58: m.nodeId = r.string(); break;
      case 64: m.line = r.int32(); break;
      case 72: m.column = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSessionStatistics(m: Init<T.SessionStatistics>, w: Writer): void {
  if (m.sessionId != null) w.string(10, m.sessionId);
  if (m.state != null) w.int32(16, m.state);
  if (m.timeMs != null) w.double(25, m.timeMs);
  if (m.modules != null) for (const e of m.modules) { const at = w.open(34); encodeModuleStatistics(e, w); w.close(at); }
  if (m.passesPerSecond != null) w.double(41, m.passesPerSecond);
  if (m.passP50Ms != null) w.double(49, m.passP50Ms);
  if (m.passP95Ms != null) w.double(57, m.passP95Ms);
  if (m.lateAnswers != null) w.double(65, m.lateAnswers);
  if (m.memoryLimitBytes != null) w.double(73, m.memoryLimitBytes);
}

export function decodeSessionStatistics(r: Reader, into?: T.SessionStatistics): T.SessionStatistics {
  const m: T.SessionStatistics = into ?? { sessionId: '', state: 0, timeMs: 0, modules: [], passesPerSecond: 0, passP50Ms: 0, passP95Ms: 0, lateAnswers: 0, memoryLimitBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.sessionId = r.string(); break;
      case 16: m.state = r.int32() as T.SessionState; break;
      case 25: m.timeMs = r.double(); break;
      case 34: { const end = r.enter(); m.modules.push(decodeModuleStatistics(r)); r.end = end; break; }
      case 41: m.passesPerSecond = r.double(); break;
      case 49: m.passP50Ms = r.double(); break;
      case 57: m.passP95Ms = r.double(); break;
      case 65: m.lateAnswers = r.double(); break;
      case 73: m.memoryLimitBytes = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSetting(m: Init<T.Setting>, w: Writer): void {
  if (m.flag != null) w.string(10, m.flag);
  if (m.value != null) w.string(18, m.value);
  if (m.description != null) w.string(26, m.description);
  if (m.given != null) w.bool(32, m.given);
}

export function decodeSetting(r: Reader, into?: T.Setting): T.Setting {
  const m: T.Setting = into ?? { flag: '', value: '', description: '', given: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.flag = r.string(); break;
      case 18: m.value = r.string(); break;
      case 26: m.description = r.string(); break;
      case 32: m.given = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSettingList(m: Init<T.SettingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeSetting(e, w); w.close(at); }
  if (m.runtime != null) w.string(18, m.runtime);
}

export function decodeSettingList(r: Reader, into?: T.SettingList): T.SettingList {
  const m: T.SettingList = into ?? { elements: [], runtime: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeSetting(r)); r.end = end; break; }
      case 18: m.runtime = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStatusEvent(m: Init<T.StatusEvent>, w: Writer): void {
  if (m.timeMs != null) w.double(9, m.timeMs);
  if (m.kind != null) w.int32(16, m.kind);
  if (m.text != null) w.string(26, m.text);
  if (m.clientId != null) w.string(34, m.clientId);
}

export function decodeStatusEvent(r: Reader, into?: T.StatusEvent): T.StatusEvent {
  const m: T.StatusEvent = into ?? { timeMs: 0, kind: 0, text: '', clientId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.timeMs = r.double(); break;
      case 16: m.kind = r.int32() as T.StatusEventKind; break;
      case 26: m.text = r.string(); break;
      case 34: m.clientId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStatusProblem(m: Init<T.StatusProblem>, w: Writer): void {
  if (m.code != null) w.string(10, m.code);
  if (m.severity != null) w.int32(16, m.severity);
  if (m.text != null) w.string(26, m.text);
  if (m.clientId != null) w.string(34, m.clientId);
  if (m.sinceMs != null) w.double(41, m.sinceMs);
  if (m.remedy != null) w.string(50, m.remedy);
  if (m.sessionId != null) w.string(58, m.sessionId);
  if (m.moduleId != null) w.string(66, m.moduleId);
}

export function decodeStatusProblem(r: Reader, into?: T.StatusProblem): T.StatusProblem {
  const m: T.StatusProblem = into ?? { code: '', severity: 0, text: '', clientId: '', sinceMs: 0, remedy: '', sessionId: '', moduleId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.code = r.string(); break;
      case 16: m.severity = r.int32() as T.StatusProblemSeverity; break;
      case 26: m.text = r.string(); break;
      case 34: m.clientId = r.string(); break;
      case 41: m.sinceMs = r.double(); break;
      case 50: m.remedy = r.string(); break;
      case 58: m.sessionId = r.string(); break;
      case 66: m.moduleId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStatusSample(m: Init<T.StatusSample>, w: Writer): void {
  if (m.timeMs != null) w.double(9, m.timeMs);
  if (m.recordsPerSecond != null) w.float(21, m.recordsPerSecond);
  if (m.cpuPercent != null) w.double(25, m.cpuPercent);
  if (m.busyPercent != null) w.double(33, m.busyPercent);
  if (m.delayMs != null) w.double(41, m.delayMs);
  if (m.recordsOutPerSecond != null) w.double(49, m.recordsOutPerSecond);
}

export function decodeStatusSample(r: Reader, into?: T.StatusSample): T.StatusSample {
  const m: T.StatusSample = into ?? { timeMs: 0, recordsPerSecond: 0, cpuPercent: 0, busyPercent: 0, delayMs: 0, recordsOutPerSecond: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.timeMs = r.double(); break;
      case 21: m.recordsPerSecond = r.float(); break;
      case 25: m.cpuPercent = r.double(); break;
      case 33: m.busyPercent = r.double(); break;
      case 41: m.delayMs = r.double(); break;
      case 49: m.recordsOutPerSecond = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSubscribedModule(m: Init<T.SubscribedModule>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
  if (m.sessionId != null) w.string(18, m.sessionId);
  if (m.sessionName != null) w.string(26, m.sessionName);
  if (m.nodeId != null) w.string(34, m.nodeId);
}

export function decodeSubscribedModule(r: Reader, into?: T.SubscribedModule): T.SubscribedModule {
  const m: T.SubscribedModule = into ?? { name: '', sessionId: '', sessionName: '', nodeId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      case 18: m.sessionId = r.string(); break;
      case 26: m.sessionName = r.string(); break;
      case 34: m.nodeId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicStatistic(m: Init<T.TopicStatistic>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.dataFormat != null) w.string(18, m.dataFormat);
  if (m.publisherId != null) w.string(26, m.publisherId);
  if (m.records != null) w.double(33, m.records);
  if (m.bytes != null) w.double(41, m.bytes);
  if (m.dropped != null) w.double(49, m.dropped);
  if (m.publishedMs != null) w.double(57, m.publishedMs);
  if (m.subscribers != null) w.int32(64, m.subscribers);
  if (m.valueBytes != null) w.int32(72, m.valueBytes);
}

export function decodeTopicStatistic(r: Reader, into?: T.TopicStatistic): T.TopicStatistic {
  const m: T.TopicStatistic = into ?? { topic: '', dataFormat: '', publisherId: '', records: 0, bytes: 0, dropped: 0, publishedMs: 0, subscribers: 0, valueBytes: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.dataFormat = r.string(); break;
      case 26: m.publisherId = r.string(); break;
      case 33: m.records = r.double(); break;
      case 41: m.bytes = r.double(); break;
      case 49: m.dropped = r.double(); break;
      case 57: m.publishedMs = r.double(); break;
      case 64: m.subscribers = r.int32(); break;
      case 72: m.valueBytes = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicStatistics(m: Init<T.TopicStatistics>, w: Writer): void {
  if (m.cursor != null) w.double(9, m.cursor);
  if (m.reset != null) w.bool(16, m.reset);
  if (m.elements != null) for (const e of m.elements) { const at = w.open(26); encodeTopicStatistic(e, w); w.close(at); }
  if (m.removed != null) for (const e of m.removed) w.string(34, e);
  if (m.masterTimeMs != null) w.double(41, m.masterTimeMs);
}

export function decodeTopicStatistics(r: Reader, into?: T.TopicStatistics): T.TopicStatistics {
  const m: T.TopicStatistics = into ?? { cursor: 0, reset: false, elements: [], removed: [], masterTimeMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.cursor = r.double(); break;
      case 16: m.reset = r.bool(); break;
      case 26: { const end = r.enter(); m.elements.push(decodeTopicStatistic(r)); r.end = end; break; }
      case 34: m.removed.push(r.string()); break;
      case 41: m.masterTimeMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicStatisticsRequest(m: Init<T.TopicStatisticsRequest>, w: Writer): void {
  if (m.cursor != null) w.double(9, m.cursor);
}

export function decodeTopicStatisticsRequest(r: Reader, into?: T.TopicStatisticsRequest): T.TopicStatisticsRequest {
  const m: T.TopicStatisticsRequest = into ?? { cursor: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.cursor = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicSubscribers(m: Init<T.TopicSubscribers>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.count != null) w.int32(16, m.count);
  if (m.clientIds != null) for (const e of m.clientIds) w.string(26, e);
  if (m.modules != null) for (const e of m.modules) { const at = w.open(34); encodeSubscribedModule(e, w); w.close(at); }
}

export function decodeTopicSubscribers(r: Reader, into?: T.TopicSubscribers): T.TopicSubscribers {
  const m: T.TopicSubscribers = into ?? { topic: '', count: 0, clientIds: [], modules: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 16: m.count = r.int32(); break;
      case 26: m.clientIds.push(r.string()); break;
      case 34: { const end = r.enter(); m.modules.push(decodeSubscribedModule(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicSubscribersList(m: Init<T.TopicSubscribersList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicSubscribers(e, w); w.close(at); }
}

export function decodeTopicSubscribersList(r: Reader, into?: T.TopicSubscribersList): T.TopicSubscribersList {
  const m: T.TopicSubscribersList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicSubscribers(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicSubscribersRequest(m: Init<T.TopicSubscribersRequest>, w: Writer): void {
  if (m.topics != null) for (const e of m.topics) w.string(10, e);
}

export function decodeTopicSubscribersRequest(r: Reader, into?: T.TopicSubscribersRequest): T.TopicSubscribersRequest {
  const m: T.TopicSubscribersRequest = into ?? { topics: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topics.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeErrorMessage(m: Init<T.ErrorMessage>, w: Writer): void {
  if (m.title != null) w.string(10, m.title);
  if (m.message != null) w.string(18, m.message);
  if (m.stack != null) w.string(26, m.stack);
  if (m.code != null) w.string(8002, m.code);
  if (m.problems != null) for (const e of m.problems) { const at = w.open(8010); encodeSessionProblem(e, w); w.close(at); }
  if (m.join != null) { const at = w.open(8018); encodeJoinRefusal(m.join, w); w.close(at); }
}

export function decodeErrorMessage(r: Reader, into?: T.ErrorMessage): T.ErrorMessage {
  const m: T.ErrorMessage = into ?? { title: '', message: '', stack: '', code: '', problems: [], join: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.title = r.string(); break;
      case 18: m.message = r.string(); break;
      case 26: m.stack = r.string(); break;
      case 8002: m.code = r.string(); break;
      case 8010: { const end = r.enter(); m.problems.push(decodeSessionProblem(r)); r.end = end; break; }
      case 8018: { const end = r.enter(); m.join = decodeJoinRefusal(r, m.join); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeErrorList(m: Init<T.ErrorList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeErrorMessage(e, w); w.close(at); }
}

export function decodeErrorList(r: Reader, into?: T.ErrorList): T.ErrorList {
  const m: T.ErrorList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeErrorMessage(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSuccess(m: Init<T.Success>, w: Writer): void {
  if (m.title != null) w.string(10, m.title);
  if (m.message != null) w.string(18, m.message);
}

export function decodeSuccess(r: Reader, into?: T.Success): T.Success {
  const m: T.Success = into ?? { title: '', message: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.title = r.string(); break;
      case 18: m.message = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSuccessList(m: Init<T.SuccessList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeSuccess(e, w); w.close(at); }
}

export function decodeSuccessList(r: Reader, into?: T.SuccessList): T.SuccessList {
  const m: T.SuccessList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeSuccess(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLockstepProcessingReply(m: Init<T.LockstepProcessingReply>, w: Writer): void {
  if (m.processingModuleIds != null) for (const e of m.processingModuleIds) w.string(10, e);
  if (m.records != null) for (const e of m.records) { const at = w.open(18); encodeTopicDataRecord(e, w); w.close(at); }
  if (m.pass != null) w.int32(8000, m.pass);
  if (m.sessionId != null) w.string(8010, m.sessionId);
}

export function decodeLockstepProcessingReply(r: Reader, into?: T.LockstepProcessingReply): T.LockstepProcessingReply {
  const m: T.LockstepProcessingReply = into ?? { processingModuleIds: [], records: [], pass: 0, sessionId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processingModuleIds.push(r.string()); break;
      case 18: { const end = r.enter(); m.records.push(decodeTopicDataRecord(r)); r.end = end; break; }
      case 8000: m.pass = r.int32(); break;
      case 8010: m.sessionId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeLockstepProcessingRequest(m: Init<T.LockstepProcessingRequest>, w: Writer): void {
  if (m.processingModuleIds != null) for (const e of m.processingModuleIds) w.string(10, e);
  if (m.records != null) for (const e of m.records) { const at = w.open(18); encodeTopicDataRecord(e, w); w.close(at); }
  if (m.deltaTimeMs != null) w.int32(24, m.deltaTimeMs);
  if (m.pass != null) w.int32(8000, m.pass);
  if (m.sessionId != null) w.string(8010, m.sessionId);
  if (m.deltaTime != null) w.double(8017, m.deltaTime);
}

export function decodeLockstepProcessingRequest(r: Reader, into?: T.LockstepProcessingRequest): T.LockstepProcessingRequest {
  const m: T.LockstepProcessingRequest = into ?? { processingModuleIds: [], records: [], deltaTimeMs: 0, pass: 0, sessionId: '', deltaTime: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processingModuleIds.push(r.string()); break;
      case 18: { const end = r.enter(); m.records.push(decodeTopicDataRecord(r)); r.end = end; break; }
      case 24: m.deltaTimeMs = r.int32(); break;
      case 8000: m.pass = r.int32(); break;
      case 8010: m.sessionId = r.string(); break;
      case 8017: m.deltaTime = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeModuleIO(m: Init<T.ModuleIO>, w: Writer): void {
  if (m.internalName != null) w.string(10, m.internalName);
  if (m.messageFormat != null) w.string(18, m.messageFormat);
  if (m.isRecordList != null) w.bool(24, m.isRecordList);
  if (m.defaultJson != null) w.string(8002, m.defaultJson);
  if (m.description != null) w.string(8010, m.description);
  if (m.choices != null) for (const e of m.choices) w.string(8018, e);
}

export function decodeModuleIO(r: Reader, into?: T.ModuleIO): T.ModuleIO {
  const m: T.ModuleIO = into ?? { internalName: '', messageFormat: '', isRecordList: false, defaultJson: '', description: '', choices: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.internalName = r.string(); break;
      case 18: m.messageFormat = r.string(); break;
      case 24: m.isRecordList = r.bool(); break;
      case 8002: m.defaultJson = r.string(); break;
      case 8010: m.description = r.string(); break;
      case 8018: m.choices.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingMode(m: Init<T.ProcessingMode>, w: Writer): void {
  if (m.frequency != null) { const at = w.open(10); encodeProcessingModeFrequency(m.frequency, w); w.close(at); }
  if (m.lockstep != null) { const at = w.open(18); encodeProcessingModeLockstep(m.lockstep, w); w.close(at); }
  if (m.triggerOnInput != null) { const at = w.open(26); encodeProcessingModeTriggerOnInput(m.triggerOnInput, w); w.close(at); }
  if (m.free != null) { const at = w.open(34); encodeProcessingModeFree(m.free, w); w.close(at); }
}

const ProcessingMode_mode = ['frequency', 'lockstep', 'triggerOnInput', 'free'] as const;
export function decodeProcessingMode(r: Reader, into?: T.ProcessingMode): T.ProcessingMode {
  const m: T.ProcessingMode = into ?? {};
  let mode = into && setMember(into, ProcessingMode_mode);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: mode = only(m, mode, 'frequency'); { const end = r.enter(); m.frequency = decodeProcessingModeFrequency(r, m.frequency); r.end = end; break; }
      case 18: mode = only(m, mode, 'lockstep'); { const end = r.enter(); m.lockstep = decodeProcessingModeLockstep(r, m.lockstep); r.end = end; break; }
      case 26: mode = only(m, mode, 'triggerOnInput'); { const end = r.enter(); m.triggerOnInput = decodeProcessingModeTriggerOnInput(r, m.triggerOnInput); r.end = end; break; }
      case 34: mode = only(m, mode, 'free'); { const end = r.enter(); m.free = decodeProcessingModeFree(r, m.free); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeFree(_m: Init<T.ProcessingModeFree>, _w: Writer): void {
}

export function decodeProcessingModeFree(r: Reader, into?: T.ProcessingModeFree): T.ProcessingModeFree {
  const m: T.ProcessingModeFree = into ?? {};
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeFrequency(m: Init<T.ProcessingModeFrequency>, w: Writer): void {
  if (m.hertz != null) w.int32(8, m.hertz);
}

export function decodeProcessingModeFrequency(r: Reader, into?: T.ProcessingModeFrequency): T.ProcessingModeFrequency {
  const m: T.ProcessingModeFrequency = into ?? { hertz: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.hertz = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeLockstep(m: Init<T.ProcessingModeLockstep>, w: Writer): void {
  if (m.processRequestEndpoint != null) w.string(10, m.processRequestEndpoint);
}

export function decodeProcessingModeLockstep(r: Reader, into?: T.ProcessingModeLockstep): T.ProcessingModeLockstep {
  const m: T.ProcessingModeLockstep = into ?? { processRequestEndpoint: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processRequestEndpoint = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModeTriggerOnInput(m: Init<T.ProcessingModeTriggerOnInput>, w: Writer): void {
  if (m.minDelayMs != null) w.int32(8, m.minDelayMs);
  if (m.allInputsNeedUpdate != null) w.bool(16, m.allInputsNeedUpdate);
}

export function decodeProcessingModeTriggerOnInput(r: Reader, into?: T.ProcessingModeTriggerOnInput): T.ProcessingModeTriggerOnInput {
  const m: T.ProcessingModeTriggerOnInput = into ?? { minDelayMs: 0, allInputsNeedUpdate: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.minDelayMs = r.int32(); break;
      case 16: m.allInputsNeedUpdate = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModule(m: Init<T.ProcessingModule>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.authors != null) for (const e of m.authors) w.string(26, e);
  if (m.tags != null) for (const e of m.tags) w.string(34, e);
  if (m.description != null) w.string(42, m.description);
  if (m.nodeId != null) w.string(50, m.nodeId);
  if (m.sessionId != null) w.string(58, m.sessionId);
  if (m.status != null) w.int32(64, m.status);
  if (m.processingMode != null) { const at = w.open(74); encodeProcessingMode(m.processingMode, w); w.close(at); }
  if (m.inputs != null) for (const e of m.inputs) { const at = w.open(82); encodeModuleIO(e, w); w.close(at); }
  if (m.outputs != null) for (const e of m.outputs) { const at = w.open(90); encodeModuleIO(e, w); w.close(at); }
  if (m.language != null && m.language !== 0) w.int32(96, m.language);
  if (m.onProcessingStringified != null) w.string(106, m.onProcessingStringified);
  if (m.onCreatedStringified != null) w.string(114, m.onCreatedStringified);
  if (m.onHaltedStringified != null) w.string(122, m.onHaltedStringified);
  if (m.onDestroyedStringified != null) w.string(130, m.onDestroyedStringified);
  if (m.extension != null) { const at = w.open(8002); encodeModuleExtension(m.extension, w); w.close(at); }
}

export function decodeProcessingModule(r: Reader, into?: T.ProcessingModule): T.ProcessingModule {
  const m: T.ProcessingModule = into ?? { id: '', name: '', authors: [], tags: [], description: '', nodeId: '', sessionId: '', status: 0, processingMode: undefined, inputs: [], outputs: [], language: 0, onProcessingStringified: '', onCreatedStringified: '', onHaltedStringified: '', onDestroyedStringified: '', extension: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.authors.push(r.string()); break;
      case 34: m.tags.push(r.string()); break;
      case 42: m.description = r.string(); break;
      case 50: m.nodeId = r.string(); break;
      case 58: m.sessionId = r.string(); break;
      case 64: m.status = r.int32() as T.ProcessingModuleStatus; break;
      case 74: { const end = r.enter(); m.processingMode = decodeProcessingMode(r, m.processingMode); r.end = end; break; }
      case 82: { const end = r.enter(); m.inputs.push(decodeModuleIO(r)); r.end = end; break; }
      case 90: { const end = r.enter(); m.outputs.push(decodeModuleIO(r)); r.end = end; break; }
      case 96: m.language = r.int32() as T.ProcessingModuleLanguage; break;
      case 106: m.onProcessingStringified = r.string(); break;
      case 114: m.onCreatedStringified = r.string(); break;
      case 122: m.onHaltedStringified = r.string(); break;
      case 130: m.onDestroyedStringified = r.string(); break;
      case 8002: { const end = r.enter(); m.extension = decodeModuleExtension(r, m.extension); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeProcessingModuleList(m: Init<T.ProcessingModuleList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeProcessingModule(e, w); w.close(at); }
}

export function decodeProcessingModuleList(r: Reader, into?: T.ProcessingModuleList): T.ProcessingModuleList {
  const m: T.ProcessingModuleList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeProcessingModule(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeServer(m: Init<T.Server>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.ipEthernet != null) w.string(26, m.ipEthernet);
  if (m.ipWlan != null) w.string(34, m.ipWlan);
  if (m.portServiceZmq != null) w.string(42, m.portServiceZmq);
  if (m.portServiceRest != null) w.string(50, m.portServiceRest);
  if (m.portTopicDataZmq != null) w.string(58, m.portTopicDataZmq);
  if (m.portTopicDataWs != null) w.string(66, m.portTopicDataWs);
  if (m.constantsJson != null) w.string(74, m.constantsJson);
  if (m.externalAddressServiceZmq != null) w.string(82, m.externalAddressServiceZmq);
  if (m.externalAddressServiceHttpJson != null) w.string(90, m.externalAddressServiceHttpJson);
  if (m.externalAddressServiceHttpBinary != null) w.string(98, m.externalAddressServiceHttpBinary);
  if (m.externalAddressTopicDataZmq != null) w.string(106, m.externalAddressTopicDataZmq);
  if (m.externalAddressTopicDataWs != null) w.string(114, m.externalAddressTopicDataWs);
}

export function decodeServer(r: Reader, into?: T.Server): T.Server {
  const m: T.Server = into ?? { id: '', name: '', ipEthernet: '', ipWlan: '', portServiceZmq: '', portServiceRest: '', portTopicDataZmq: '', portTopicDataWs: '', constantsJson: '', externalAddressServiceZmq: '', externalAddressServiceHttpJson: '', externalAddressServiceHttpBinary: '', externalAddressTopicDataZmq: '', externalAddressTopicDataWs: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.ipEthernet = r.string(); break;
      case 34: m.ipWlan = r.string(); break;
      case 42: m.portServiceZmq = r.string(); break;
      case 50: m.portServiceRest = r.string(); break;
      case 58: m.portTopicDataZmq = r.string(); break;
      case 66: m.portTopicDataWs = r.string(); break;
      case 74: m.constantsJson = r.string(); break;
      case 82: m.externalAddressServiceZmq = r.string(); break;
      case 90: m.externalAddressServiceHttpJson = r.string(); break;
      case 98: m.externalAddressServiceHttpBinary = r.string(); break;
      case 106: m.externalAddressTopicDataZmq = r.string(); break;
      case 114: m.externalAddressTopicDataWs = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeService(m: Init<T.Service>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.requestMessageFormat != null) w.string(18, m.requestMessageFormat);
  if (m.responseMessageFormat != null) w.string(26, m.responseMessageFormat);
  if (m.tags != null) for (const e of m.tags) w.string(34, e);
  if (m.description != null) w.string(42, m.description);
}

export function decodeService(r: Reader, into?: T.Service): T.Service {
  const m: T.Service = into ?? { topic: '', requestMessageFormat: '', responseMessageFormat: '', tags: [], description: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.requestMessageFormat = r.string(); break;
      case 26: m.responseMessageFormat = r.string(); break;
      case 34: m.tags.push(r.string()); break;
      case 42: m.description = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeServiceList(m: Init<T.ServiceList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeService(e, w); w.close(at); }
}

export function decodeServiceList(r: Reader, into?: T.ServiceList): T.ServiceList {
  const m: T.ServiceList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeService(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeServiceReply(m: Init<T.ServiceReply>, w: Writer): void {
  if (m.success != null) { const at = w.open(10); encodeSuccess(m.success, w); w.close(at); }
  if (m.error != null) { const at = w.open(18); encodeErrorMessage(m.error, w); w.close(at); }
  if (m.client != null) { const at = w.open(26); encodeClient(m.client, w); w.close(at); }
  if (m.device != null) { const at = w.open(34); encodeDevice(m.device, w); w.close(at); }
  if (m.server != null) { const at = w.open(42); encodeServer(m.server, w); w.close(at); }
  if (m.session != null) { const at = w.open(50); encodeSession(m.session, w); w.close(at); }
  if (m.sessionList != null) { const at = w.open(58); encodeSessionList(m.sessionList, w); w.close(at); }
  if (m.processingModule != null) { const at = w.open(66); encodeProcessingModule(m.processingModule, w); w.close(at); }
  if (m.processingModuleList != null) { const at = w.open(74); encodeProcessingModuleList(m.processingModuleList, w); w.close(at); }
  if (m.stringList != null) { const at = w.open(82); encodeStringList(m.stringList, w); w.close(at); }
  if (m.topicMux != null) { const at = w.open(90); encodeTopicMux(m.topicMux, w); w.close(at); }
  if (m.topicMuxList != null) { const at = w.open(98); encodeTopicMuxList(m.topicMuxList, w); w.close(at); }
  if (m.topicDemux != null) { const at = w.open(106); encodeTopicDemux(m.topicDemux, w); w.close(at); }
  if (m.topicDemuxList != null) { const at = w.open(114); encodeTopicDemuxList(m.topicDemuxList, w); w.close(at); }
  if (m.clientList != null) { const at = w.open(122); encodeClientList(m.clientList, w); w.close(at); }
  if (m.deviceList != null) { const at = w.open(130); encodeDeviceList(m.deviceList, w); w.close(at); }
  if (m.service != null) { const at = w.open(138); encodeService(m.service, w); w.close(at); }
  if (m.serviceList != null) { const at = w.open(146); encodeServiceList(m.serviceList, w); w.close(at); }
  if (m.lockstepProcessingReply != null) { const at = w.open(154); encodeLockstepProcessingReply(m.lockstepProcessingReply, w); w.close(at); }
  if (m.component != null) { const at = w.open(162); encodeComponent(m.component, w); w.close(at); }
  if (m.componentList != null) { const at = w.open(170); encodeComponentList(m.componentList, w); w.close(at); }
  if (m.notifyCondition != null) { const at = w.open(178); encodeNotifyCondition(m.notifyCondition, w); w.close(at); }
  if (m.topicStatistics != null) { const at = w.open(8002); encodeTopicStatistics(m.topicStatistics, w); w.close(at); }
  if (m.masterStatus != null) { const at = w.open(8010); encodeMasterStatus(m.masterStatus, w); w.close(at); }
  if (m.nodeList != null) { const at = w.open(8018); encodeNodeList(m.nodeList, w); w.close(at); }
  if (m.clientReport != null) { const at = w.open(8026); encodeClientReport(m.clientReport, w); w.close(at); }
  if (m.limitList != null) { const at = w.open(8034); encodeLimitList(m.limitList, w); w.close(at); }
  if (m.logTail != null) { const at = w.open(8042); encodeLogTail(m.logTail, w); w.close(at); }
  if (m.moduleVersionList != null) { const at = w.open(8050); encodeModuleVersionList(m.moduleVersionList, w); w.close(at); }
  if (m.settingList != null) { const at = w.open(8058); encodeSettingList(m.settingList, w); w.close(at); }
  if (m.assetSetList != null) { const at = w.open(8066); encodeAssetSetList(m.assetSetList, w); w.close(at); }
  if (m.topicSubscribersList != null) { const at = w.open(8074); encodeTopicSubscribersList(m.topicSubscribersList, w); w.close(at); }
  if (m.joinCheck != null) { const at = w.open(8162); encodeJoinCheck(m.joinCheck, w); w.close(at); }
  if (m.accessGrantCreated != null) { const at = w.open(8170); encodeAccessGrantCreated(m.accessGrantCreated, w); w.close(at); }
  if (m.accessGrant != null) { const at = w.open(8178); encodeAccessGrant(m.accessGrant, w); w.close(at); }
  if (m.accessGrantList != null) { const at = w.open(8186); encodeAccessGrantList(m.accessGrantList, w); w.close(at); }
  if (m.auditLog != null) { const at = w.open(8322); encodeAuditLog(m.auditLog, w); w.close(at); }
  if (m.recording != null) { const at = w.open(8402); encodeRecording(m.recording, w); w.close(at); }
  if (m.recordingList != null) { const at = w.open(8410); encodeRecordingList(m.recordingList, w); w.close(at); }
  if (m.recordingMarker != null) { const at = w.open(8418); encodeRecordingMarker(m.recordingMarker, w); w.close(at); }
  if (m.recordingEstimate != null) { const at = w.open(8426); encodeRecordingEstimate(m.recordingEstimate, w); w.close(at); }
  if (m.flightRecorder != null) { const at = w.open(8434); encodeFlightRecorder(m.flightRecorder, w); w.close(at); }
}

const ServiceReply_type = ['success', 'error', 'client', 'device', 'server', 'session', 'sessionList', 'processingModule', 'processingModuleList', 'stringList', 'topicMux', 'topicMuxList', 'topicDemux', 'topicDemuxList', 'clientList', 'deviceList', 'service', 'serviceList', 'lockstepProcessingReply', 'component', 'componentList', 'notifyCondition', 'topicStatistics', 'masterStatus', 'nodeList', 'clientReport', 'limitList', 'logTail', 'moduleVersionList', 'settingList', 'assetSetList', 'topicSubscribersList', 'joinCheck', 'accessGrantCreated', 'accessGrant', 'accessGrantList', 'auditLog', 'recording', 'recordingList', 'recordingMarker', 'recordingEstimate', 'flightRecorder'] as const;
export function decodeServiceReply(r: Reader, into?: T.ServiceReply): T.ServiceReply {
  const m: T.ServiceReply = into ?? {};
  let type = into && setMember(into, ServiceReply_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: type = only(m, type, 'success'); { const end = r.enter(); m.success = decodeSuccess(r, m.success); r.end = end; break; }
      case 18: type = only(m, type, 'error'); { const end = r.enter(); m.error = decodeErrorMessage(r, m.error); r.end = end; break; }
      case 26: type = only(m, type, 'client'); { const end = r.enter(); m.client = decodeClient(r, m.client); r.end = end; break; }
      case 34: type = only(m, type, 'device'); { const end = r.enter(); m.device = decodeDevice(r, m.device); r.end = end; break; }
      case 42: type = only(m, type, 'server'); { const end = r.enter(); m.server = decodeServer(r, m.server); r.end = end; break; }
      case 50: type = only(m, type, 'session'); { const end = r.enter(); m.session = decodeSession(r, m.session); r.end = end; break; }
      case 58: type = only(m, type, 'sessionList'); { const end = r.enter(); m.sessionList = decodeSessionList(r, m.sessionList); r.end = end; break; }
      case 66: type = only(m, type, 'processingModule'); { const end = r.enter(); m.processingModule = decodeProcessingModule(r, m.processingModule); r.end = end; break; }
      case 74: type = only(m, type, 'processingModuleList'); { const end = r.enter(); m.processingModuleList = decodeProcessingModuleList(r, m.processingModuleList); r.end = end; break; }
      case 82: type = only(m, type, 'stringList'); { const end = r.enter(); m.stringList = decodeStringList(r, m.stringList); r.end = end; break; }
      case 90: type = only(m, type, 'topicMux'); { const end = r.enter(); m.topicMux = decodeTopicMux(r, m.topicMux); r.end = end; break; }
      case 98: type = only(m, type, 'topicMuxList'); { const end = r.enter(); m.topicMuxList = decodeTopicMuxList(r, m.topicMuxList); r.end = end; break; }
      case 106: type = only(m, type, 'topicDemux'); { const end = r.enter(); m.topicDemux = decodeTopicDemux(r, m.topicDemux); r.end = end; break; }
      case 114: type = only(m, type, 'topicDemuxList'); { const end = r.enter(); m.topicDemuxList = decodeTopicDemuxList(r, m.topicDemuxList); r.end = end; break; }
      case 122: type = only(m, type, 'clientList'); { const end = r.enter(); m.clientList = decodeClientList(r, m.clientList); r.end = end; break; }
      case 130: type = only(m, type, 'deviceList'); { const end = r.enter(); m.deviceList = decodeDeviceList(r, m.deviceList); r.end = end; break; }
      case 138: type = only(m, type, 'service'); { const end = r.enter(); m.service = decodeService(r, m.service); r.end = end; break; }
      case 146: type = only(m, type, 'serviceList'); { const end = r.enter(); m.serviceList = decodeServiceList(r, m.serviceList); r.end = end; break; }
      case 154: type = only(m, type, 'lockstepProcessingReply'); { const end = r.enter(); m.lockstepProcessingReply = decodeLockstepProcessingReply(r, m.lockstepProcessingReply); r.end = end; break; }
      case 162: type = only(m, type, 'component'); { const end = r.enter(); m.component = decodeComponent(r, m.component); r.end = end; break; }
      case 170: type = only(m, type, 'componentList'); { const end = r.enter(); m.componentList = decodeComponentList(r, m.componentList); r.end = end; break; }
      case 178: type = only(m, type, 'notifyCondition'); { const end = r.enter(); m.notifyCondition = decodeNotifyCondition(r, m.notifyCondition); r.end = end; break; }
      case 8002: type = only(m, type, 'topicStatistics'); { const end = r.enter(); m.topicStatistics = decodeTopicStatistics(r, m.topicStatistics); r.end = end; break; }
      case 8010: type = only(m, type, 'masterStatus'); { const end = r.enter(); m.masterStatus = decodeMasterStatus(r, m.masterStatus); r.end = end; break; }
      case 8018: type = only(m, type, 'nodeList'); { const end = r.enter(); m.nodeList = decodeNodeList(r, m.nodeList); r.end = end; break; }
      case 8026: type = only(m, type, 'clientReport'); { const end = r.enter(); m.clientReport = decodeClientReport(r, m.clientReport); r.end = end; break; }
      case 8034: type = only(m, type, 'limitList'); { const end = r.enter(); m.limitList = decodeLimitList(r, m.limitList); r.end = end; break; }
      case 8042: type = only(m, type, 'logTail'); { const end = r.enter(); m.logTail = decodeLogTail(r, m.logTail); r.end = end; break; }
      case 8050: type = only(m, type, 'moduleVersionList'); { const end = r.enter(); m.moduleVersionList = decodeModuleVersionList(r, m.moduleVersionList); r.end = end; break; }
      case 8058: type = only(m, type, 'settingList'); { const end = r.enter(); m.settingList = decodeSettingList(r, m.settingList); r.end = end; break; }
      case 8066: type = only(m, type, 'assetSetList'); { const end = r.enter(); m.assetSetList = decodeAssetSetList(r, m.assetSetList); r.end = end; break; }
      case 8074: type = only(m, type, 'topicSubscribersList'); { const end = r.enter(); m.topicSubscribersList = decodeTopicSubscribersList(r, m.topicSubscribersList); r.end = end; break; }
      case 8162: type = only(m, type, 'joinCheck'); { const end = r.enter(); m.joinCheck = decodeJoinCheck(r, m.joinCheck); r.end = end; break; }
      case 8170: type = only(m, type, 'accessGrantCreated'); { const end = r.enter(); m.accessGrantCreated = decodeAccessGrantCreated(r, m.accessGrantCreated); r.end = end; break; }
      case 8178: type = only(m, type, 'accessGrant'); { const end = r.enter(); m.accessGrant = decodeAccessGrant(r, m.accessGrant); r.end = end; break; }
      case 8186: type = only(m, type, 'accessGrantList'); { const end = r.enter(); m.accessGrantList = decodeAccessGrantList(r, m.accessGrantList); r.end = end; break; }
      case 8322: type = only(m, type, 'auditLog'); { const end = r.enter(); m.auditLog = decodeAuditLog(r, m.auditLog); r.end = end; break; }
      case 8402: type = only(m, type, 'recording'); { const end = r.enter(); m.recording = decodeRecording(r, m.recording); r.end = end; break; }
      case 8410: type = only(m, type, 'recordingList'); { const end = r.enter(); m.recordingList = decodeRecordingList(r, m.recordingList); r.end = end; break; }
      case 8418: type = only(m, type, 'recordingMarker'); { const end = r.enter(); m.recordingMarker = decodeRecordingMarker(r, m.recordingMarker); r.end = end; break; }
      case 8426: type = only(m, type, 'recordingEstimate'); { const end = r.enter(); m.recordingEstimate = decodeRecordingEstimate(r, m.recordingEstimate); r.end = end; break; }
      case 8434: type = only(m, type, 'flightRecorder'); { const end = r.enter(); m.flightRecorder = decodeFlightRecorder(r, m.flightRecorder); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeServiceRequest(m: Init<T.ServiceRequest>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.client != null) { const at = w.open(18); encodeClient(m.client, w); w.close(at); }
  if (m.device != null) { const at = w.open(26); encodeDevice(m.device, w); w.close(at); }
  if (m.topicSubscription != null) { const at = w.open(34); encodeTopicSubscription(m.topicSubscription, w); w.close(at); }
  if (m.session != null) { const at = w.open(42); encodeSession(m.session, w); w.close(at); }
  if (m.sessionList != null) { const at = w.open(50); encodeSessionList(m.sessionList, w); w.close(at); }
  if (m.processingModule != null) { const at = w.open(58); encodeProcessingModule(m.processingModule, w); w.close(at); }
  if (m.processingModuleList != null) { const at = w.open(66); encodeProcessingModuleList(m.processingModuleList, w); w.close(at); }
  if (m.topicMux != null) { const at = w.open(74); encodeTopicMux(m.topicMux, w); w.close(at); }
  if (m.topicMuxList != null) { const at = w.open(82); encodeTopicMuxList(m.topicMuxList, w); w.close(at); }
  if (m.topicDemux != null) { const at = w.open(90); encodeTopicDemux(m.topicDemux, w); w.close(at); }
  if (m.topicDemuxList != null) { const at = w.open(98); encodeTopicDemuxList(m.topicDemuxList, w); w.close(at); }
  if (m.clientList != null) { const at = w.open(106); encodeClientList(m.clientList, w); w.close(at); }
  if (m.deviceList != null) { const at = w.open(114); encodeDeviceList(m.deviceList, w); w.close(at); }
  if (m.lockstepProcessingRequest != null) { const at = w.open(122); encodeLockstepProcessingRequest(m.lockstepProcessingRequest, w); w.close(at); }
  if (m.component != null) { const at = w.open(130); encodeComponent(m.component, w); w.close(at); }
  if (m.componentList != null) { const at = w.open(138); encodeComponentList(m.componentList, w); w.close(at); }
  if (m.notifyCondition != null) { const at = w.open(146); encodeNotifyCondition(m.notifyCondition, w); w.close(at); }
  if (m.topicStatisticsRequest != null) { const at = w.open(8002); encodeTopicStatisticsRequest(m.topicStatisticsRequest, w); w.close(at); }
  if (m.masterStatusRequest != null) { const at = w.open(8010); encodeMasterStatusRequest(m.masterStatusRequest, w); w.close(at); }
  if (m.clientReportRequest != null) { const at = w.open(8018); encodeClientReportRequest(m.clientReportRequest, w); w.close(at); }
  if (m.clientRenameRequest != null) { const at = w.open(8026); encodeClientRenameRequest(m.clientRenameRequest, w); w.close(at); }
  if (m.clientDisconnectRequest != null) { const at = w.open(8034); encodeClientDisconnectRequest(m.clientDisconnectRequest, w); w.close(at); }
  if (m.clientThrottleRequest != null) { const at = w.open(8042); encodeClientThrottleRequest(m.clientThrottleRequest, w); w.close(at); }
  if (m.logRequest != null) { const at = w.open(8050); encodeLogRequest(m.logRequest, w); w.close(at); }
  if (m.moduleVersionRequest != null) { const at = w.open(8058); encodeModuleVersionRequest(m.moduleVersionRequest, w); w.close(at); }
  if (m.assetSetRequest != null) { const at = w.open(8066); encodeAssetSetRequest(m.assetSetRequest, w); w.close(at); }
  if (m.topicSubscribersRequest != null) { const at = w.open(8074); encodeTopicSubscribersRequest(m.topicSubscribersRequest, w); w.close(at); }
  if (m.joinCheckRequest != null) { const at = w.open(8162); encodeJoinCheckRequest(m.joinCheckRequest, w); w.close(at); }
  if (m.accessGrantCreateRequest != null) { const at = w.open(8170); encodeAccessGrantCreateRequest(m.accessGrantCreateRequest, w); w.close(at); }
  if (m.accessGrantRevokeRequest != null) { const at = w.open(8178); encodeAccessGrantRevokeRequest(m.accessGrantRevokeRequest, w); w.close(at); }
  if (m.auditLogRequest != null) { const at = w.open(8322); encodeAuditLogRequest(m.auditLogRequest, w); w.close(at); }
  if (m.recordingRequest != null) { const at = w.open(8402); encodeRecordingRequest(m.recordingRequest, w); w.close(at); }
  if (m.recordingStartRequest != null) { const at = w.open(8410); encodeRecordingStartRequest(m.recordingStartRequest, w); w.close(at); }
  if (m.recordingChangeRequest != null) { const at = w.open(8418); encodeRecordingChangeRequest(m.recordingChangeRequest, w); w.close(at); }
  if (m.recordingMarker != null) { const at = w.open(8426); encodeRecordingMarker(m.recordingMarker, w); w.close(at); }
  if (m.recordingSelection != null) { const at = w.open(8434); encodeRecordingSelection(m.recordingSelection, w); w.close(at); }
  if (m.flightRecorderSettings != null) { const at = w.open(8442); encodeFlightRecorderSettings(m.flightRecorderSettings, w); w.close(at); }
  if (m.flightRecorderKeepRequest != null) { const at = w.open(8450); encodeFlightRecorderKeepRequest(m.flightRecorderKeepRequest, w); w.close(at); }
}

const ServiceRequest_type = ['client', 'device', 'topicSubscription', 'session', 'sessionList', 'processingModule', 'processingModuleList', 'topicMux', 'topicMuxList', 'topicDemux', 'topicDemuxList', 'clientList', 'deviceList', 'lockstepProcessingRequest', 'component', 'componentList', 'notifyCondition', 'topicStatisticsRequest', 'masterStatusRequest', 'clientReportRequest', 'clientRenameRequest', 'clientDisconnectRequest', 'clientThrottleRequest', 'logRequest', 'moduleVersionRequest', 'assetSetRequest', 'topicSubscribersRequest', 'joinCheckRequest', 'accessGrantCreateRequest', 'accessGrantRevokeRequest', 'auditLogRequest', 'recordingRequest', 'recordingStartRequest', 'recordingChangeRequest', 'recordingMarker', 'recordingSelection', 'flightRecorderSettings', 'flightRecorderKeepRequest'] as const;
export function decodeServiceRequest(r: Reader, into?: T.ServiceRequest): T.ServiceRequest {
  const m: T.ServiceRequest = into ?? { topic: '' };
  let type = into && setMember(into, ServiceRequest_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: type = only(m, type, 'client'); { const end = r.enter(); m.client = decodeClient(r, m.client); r.end = end; break; }
      case 26: type = only(m, type, 'device'); { const end = r.enter(); m.device = decodeDevice(r, m.device); r.end = end; break; }
      case 34: type = only(m, type, 'topicSubscription'); { const end = r.enter(); m.topicSubscription = decodeTopicSubscription(r, m.topicSubscription); r.end = end; break; }
      case 42: type = only(m, type, 'session'); { const end = r.enter(); m.session = decodeSession(r, m.session); r.end = end; break; }
      case 50: type = only(m, type, 'sessionList'); { const end = r.enter(); m.sessionList = decodeSessionList(r, m.sessionList); r.end = end; break; }
      case 58: type = only(m, type, 'processingModule'); { const end = r.enter(); m.processingModule = decodeProcessingModule(r, m.processingModule); r.end = end; break; }
      case 66: type = only(m, type, 'processingModuleList'); { const end = r.enter(); m.processingModuleList = decodeProcessingModuleList(r, m.processingModuleList); r.end = end; break; }
      case 74: type = only(m, type, 'topicMux'); { const end = r.enter(); m.topicMux = decodeTopicMux(r, m.topicMux); r.end = end; break; }
      case 82: type = only(m, type, 'topicMuxList'); { const end = r.enter(); m.topicMuxList = decodeTopicMuxList(r, m.topicMuxList); r.end = end; break; }
      case 90: type = only(m, type, 'topicDemux'); { const end = r.enter(); m.topicDemux = decodeTopicDemux(r, m.topicDemux); r.end = end; break; }
      case 98: type = only(m, type, 'topicDemuxList'); { const end = r.enter(); m.topicDemuxList = decodeTopicDemuxList(r, m.topicDemuxList); r.end = end; break; }
      case 106: type = only(m, type, 'clientList'); { const end = r.enter(); m.clientList = decodeClientList(r, m.clientList); r.end = end; break; }
      case 114: type = only(m, type, 'deviceList'); { const end = r.enter(); m.deviceList = decodeDeviceList(r, m.deviceList); r.end = end; break; }
      case 122: type = only(m, type, 'lockstepProcessingRequest'); { const end = r.enter(); m.lockstepProcessingRequest = decodeLockstepProcessingRequest(r, m.lockstepProcessingRequest); r.end = end; break; }
      case 130: type = only(m, type, 'component'); { const end = r.enter(); m.component = decodeComponent(r, m.component); r.end = end; break; }
      case 138: type = only(m, type, 'componentList'); { const end = r.enter(); m.componentList = decodeComponentList(r, m.componentList); r.end = end; break; }
      case 146: type = only(m, type, 'notifyCondition'); { const end = r.enter(); m.notifyCondition = decodeNotifyCondition(r, m.notifyCondition); r.end = end; break; }
      case 8002: type = only(m, type, 'topicStatisticsRequest'); { const end = r.enter(); m.topicStatisticsRequest = decodeTopicStatisticsRequest(r, m.topicStatisticsRequest); r.end = end; break; }
      case 8010: type = only(m, type, 'masterStatusRequest'); { const end = r.enter(); m.masterStatusRequest = decodeMasterStatusRequest(r, m.masterStatusRequest); r.end = end; break; }
      case 8018: type = only(m, type, 'clientReportRequest'); { const end = r.enter(); m.clientReportRequest = decodeClientReportRequest(r, m.clientReportRequest); r.end = end; break; }
      case 8026: type = only(m, type, 'clientRenameRequest'); { const end = r.enter(); m.clientRenameRequest = decodeClientRenameRequest(r, m.clientRenameRequest); r.end = end; break; }
      case 8034: type = only(m, type, 'clientDisconnectRequest'); { const end = r.enter(); m.clientDisconnectRequest = decodeClientDisconnectRequest(r, m.clientDisconnectRequest); r.end = end; break; }
      case 8042: type = only(m, type, 'clientThrottleRequest'); { const end = r.enter(); m.clientThrottleRequest = decodeClientThrottleRequest(r, m.clientThrottleRequest); r.end = end; break; }
      case 8050: type = only(m, type, 'logRequest'); { const end = r.enter(); m.logRequest = decodeLogRequest(r, m.logRequest); r.end = end; break; }
      case 8058: type = only(m, type, 'moduleVersionRequest'); { const end = r.enter(); m.moduleVersionRequest = decodeModuleVersionRequest(r, m.moduleVersionRequest); r.end = end; break; }
      case 8066: type = only(m, type, 'assetSetRequest'); { const end = r.enter(); m.assetSetRequest = decodeAssetSetRequest(r, m.assetSetRequest); r.end = end; break; }
      case 8074: type = only(m, type, 'topicSubscribersRequest'); { const end = r.enter(); m.topicSubscribersRequest = decodeTopicSubscribersRequest(r, m.topicSubscribersRequest); r.end = end; break; }
      case 8162: type = only(m, type, 'joinCheckRequest'); { const end = r.enter(); m.joinCheckRequest = decodeJoinCheckRequest(r, m.joinCheckRequest); r.end = end; break; }
      case 8170: type = only(m, type, 'accessGrantCreateRequest'); { const end = r.enter(); m.accessGrantCreateRequest = decodeAccessGrantCreateRequest(r, m.accessGrantCreateRequest); r.end = end; break; }
      case 8178: type = only(m, type, 'accessGrantRevokeRequest'); { const end = r.enter(); m.accessGrantRevokeRequest = decodeAccessGrantRevokeRequest(r, m.accessGrantRevokeRequest); r.end = end; break; }
      case 8322: type = only(m, type, 'auditLogRequest'); { const end = r.enter(); m.auditLogRequest = decodeAuditLogRequest(r, m.auditLogRequest); r.end = end; break; }
      case 8402: type = only(m, type, 'recordingRequest'); { const end = r.enter(); m.recordingRequest = decodeRecordingRequest(r, m.recordingRequest); r.end = end; break; }
      case 8410: type = only(m, type, 'recordingStartRequest'); { const end = r.enter(); m.recordingStartRequest = decodeRecordingStartRequest(r, m.recordingStartRequest); r.end = end; break; }
      case 8418: type = only(m, type, 'recordingChangeRequest'); { const end = r.enter(); m.recordingChangeRequest = decodeRecordingChangeRequest(r, m.recordingChangeRequest); r.end = end; break; }
      case 8426: type = only(m, type, 'recordingMarker'); { const end = r.enter(); m.recordingMarker = decodeRecordingMarker(r, m.recordingMarker); r.end = end; break; }
      case 8434: type = only(m, type, 'recordingSelection'); { const end = r.enter(); m.recordingSelection = decodeRecordingSelection(r, m.recordingSelection); r.end = end; break; }
      case 8442: type = only(m, type, 'flightRecorderSettings'); { const end = r.enter(); m.flightRecorderSettings = decodeFlightRecorderSettings(r, m.flightRecorderSettings); r.end = end; break; }
      case 8450: type = only(m, type, 'flightRecorderKeepRequest'); { const end = r.enter(); m.flightRecorderKeepRequest = decodeFlightRecorderKeepRequest(r, m.flightRecorderKeepRequest); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicSubscription(m: Init<T.TopicSubscription>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.subscribeTopics != null) for (const e of m.subscribeTopics) w.string(18, e);
  if (m.unsubscribeTopics != null) for (const e of m.unsubscribeTopics) w.string(26, e);
  if (m.subscribeTopicRegexp != null) for (const e of m.subscribeTopicRegexp) w.string(34, e);
  if (m.unsubscribeTopicRegexp != null) for (const e of m.unsubscribeTopicRegexp) w.string(42, e);
  if (m.subscribeComponents != null) for (const e of m.subscribeComponents) { const at = w.open(50); encodeComponent(e, w); w.close(at); }
  if (m.unsubscribeComponents != null) for (const e of m.unsubscribeComponents) { const at = w.open(58); encodeComponent(e, w); w.close(at); }
  if (m.maxRateHz != null) w.double(8001, m.maxRateHz);
}

export function decodeTopicSubscription(r: Reader, into?: T.TopicSubscription): T.TopicSubscription {
  const m: T.TopicSubscription = into ?? { clientId: '', subscribeTopics: [], unsubscribeTopics: [], subscribeTopicRegexp: [], unsubscribeTopicRegexp: [], subscribeComponents: [], unsubscribeComponents: [], maxRateHz: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: m.subscribeTopics.push(r.string()); break;
      case 26: m.unsubscribeTopics.push(r.string()); break;
      case 34: m.subscribeTopicRegexp.push(r.string()); break;
      case 42: m.unsubscribeTopicRegexp.push(r.string()); break;
      case 50: { const end = r.enter(); m.subscribeComponents.push(decodeComponent(r)); r.end = end; break; }
      case 58: { const end = r.enter(); m.unsubscribeComponents.push(decodeComponent(r)); r.end = end; break; }
      case 8001: m.maxRateHz = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeIOMapping(m: Init<T.IOMapping>, w: Writer): void {
  if (m.processingModuleId != null) w.string(10, m.processingModuleId);
  if (m.inputMappings != null) for (const e of m.inputMappings) { const at = w.open(18); encodeTopicInputMapping(e, w); w.close(at); }
  if (m.outputMappings != null) for (const e of m.outputMappings) { const at = w.open(26); encodeTopicOutputMapping(e, w); w.close(at); }
  if (m.processingModuleName != null) w.string(34, m.processingModuleName);
}

export function decodeIOMapping(r: Reader, into?: T.IOMapping): T.IOMapping {
  const m: T.IOMapping = into ?? { processingModuleId: '', inputMappings: [], outputMappings: [], processingModuleName: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.processingModuleId = r.string(); break;
      case 18: { const end = r.enter(); m.inputMappings.push(decodeTopicInputMapping(r)); r.end = end; break; }
      case 26: { const end = r.enter(); m.outputMappings.push(decodeTopicOutputMapping(r)); r.end = end; break; }
      case 34: m.processingModuleName = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeIOMappingList(m: Init<T.IOMappingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeIOMapping(e, w); w.close(at); }
}

export function decodeIOMappingList(r: Reader, into?: T.IOMappingList): T.IOMappingList {
  const m: T.IOMappingList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeIOMapping(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSession(m: Init<T.Session>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.processingModules != null) for (const e of m.processingModules) { const at = w.open(26); encodeProcessingModule(e, w); w.close(at); }
  if (m.ioMappings != null) for (const e of m.ioMappings) { const at = w.open(34); encodeIOMapping(e, w); w.close(at); }
  if (m.tags != null) for (const e of m.tags) w.string(42, e);
  if (m.description != null) w.string(50, m.description);
  if (m.authors != null) for (const e of m.authors) w.string(58, e);
  if (m.status != null) w.int32(64, m.status);
  if (m.editable != null) w.bool(72, m.editable);
  if (m.extension != null) { const at = w.open(8002); encodeSessionExtension(m.extension, w); w.close(at); }
}

export function decodeSession(r: Reader, into?: T.Session): T.Session {
  const m: T.Session = into ?? { id: '', name: '', processingModules: [], ioMappings: [], tags: [], description: '', authors: [], status: 0, editable: false, extension: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: { const end = r.enter(); m.processingModules.push(decodeProcessingModule(r)); r.end = end; break; }
      case 34: { const end = r.enter(); m.ioMappings.push(decodeIOMapping(r)); r.end = end; break; }
      case 42: m.tags.push(r.string()); break;
      case 50: m.description = r.string(); break;
      case 58: m.authors.push(r.string()); break;
      case 64: m.status = r.int32() as T.SessionStatus; break;
      case 72: m.editable = r.bool(); break;
      case 8002: { const end = r.enter(); m.extension = decodeSessionExtension(r, m.extension); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeSessionList(m: Init<T.SessionList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeSession(e, w); w.close(at); }
}

export function decodeSessionList(r: Reader, into?: T.SessionList): T.SessionList {
  const m: T.SessionList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeSession(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicInputMapping(m: Init<T.TopicInputMapping>, w: Writer): void {
  if (m.inputName != null) w.string(10, m.inputName);
  if (m.topic != null) w.string(18, m.topic);
  if (m.topicMux != null) { const at = w.open(26); encodeTopicMux(m.topicMux, w); w.close(at); }
  if (m.constantJson != null) w.string(8002, m.constantJson);
}

const TopicInputMapping_topic_source = ['topic', 'topicMux'] as const;
export function decodeTopicInputMapping(r: Reader, into?: T.TopicInputMapping): T.TopicInputMapping {
  const m: T.TopicInputMapping = into ?? { inputName: '', constantJson: '' };
  let topic_source = into && setMember(into, TopicInputMapping_topic_source);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.inputName = r.string(); break;
      case 18: topic_source = only(m, topic_source, 'topic'); m.topic = r.string(); break;
      case 26: topic_source = only(m, topic_source, 'topicMux'); { const end = r.enter(); m.topicMux = decodeTopicMux(r, m.topicMux); r.end = end; break; }
      case 8002: m.constantJson = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicInputMappingList(m: Init<T.TopicInputMappingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicInputMapping(e, w); w.close(at); }
}

export function decodeTopicInputMappingList(r: Reader, into?: T.TopicInputMappingList): T.TopicInputMappingList {
  const m: T.TopicInputMappingList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicInputMapping(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicOutputMapping(m: Init<T.TopicOutputMapping>, w: Writer): void {
  if (m.outputName != null) w.string(10, m.outputName);
  if (m.topic != null) w.string(18, m.topic);
  if (m.topicDemux != null) { const at = w.open(26); encodeTopicDemux(m.topicDemux, w); w.close(at); }
}

const TopicOutputMapping_topic_destination = ['topic', 'topicDemux'] as const;
export function decodeTopicOutputMapping(r: Reader, into?: T.TopicOutputMapping): T.TopicOutputMapping {
  const m: T.TopicOutputMapping = into ?? { outputName: '' };
  let topic_destination = into && setMember(into, TopicOutputMapping_topic_destination);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.outputName = r.string(); break;
      case 18: topic_destination = only(m, topic_destination, 'topic'); m.topic = r.string(); break;
      case 26: topic_destination = only(m, topic_destination, 'topicDemux'); { const end = r.enter(); m.topicDemux = decodeTopicDemux(r, m.topicDemux); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicOutputMappingList(m: Init<T.TopicOutputMappingList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicOutputMapping(e, w); w.close(at); }
}

export function decodeTopicOutputMappingList(r: Reader, into?: T.TopicOutputMappingList): T.TopicOutputMappingList {
  const m: T.TopicOutputMappingList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicOutputMapping(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTimestamp(m: Init<T.Timestamp>, w: Writer): void {
  if (m.seconds != null) w.int64(8, m.seconds);
  if (m.nanos != null) w.int32(16, m.nanos);
  if (m.millis != null) w.int64(24, m.millis);
}

export function decodeTimestamp(r: Reader, into?: T.Timestamp): T.Timestamp {
  const m: T.Timestamp = into ?? { seconds: 0, nanos: 0, millis: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.seconds = r.int64(); break;
      case 16: m.nanos = r.int32(); break;
      case 24: m.millis = r.int64(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicData(m: Init<T.TopicData>, w: Writer): void {
  if (m.topicDataRecord != null) { const at = w.open(18); encodeTopicDataRecord(m.topicDataRecord, w); w.close(at); }
  if (m.topicDataRecordList != null) { const at = w.open(26); encodeTopicDataRecordList(m.topicDataRecordList, w); w.close(at); }
  if (m.error != null) { const at = w.open(34); encodeErrorMessage(m.error, w); w.close(at); }
  if (m.nodeMessage != null) { const at = w.open(8002); encodeNodeMessage(m.nodeMessage, w); w.close(at); }
}

const TopicData_type = ['topicDataRecord', 'topicDataRecordList', 'error', 'nodeMessage'] as const;
export function decodeTopicData(r: Reader, into?: T.TopicData): T.TopicData {
  const m: T.TopicData = into ?? {};
  let type = into && setMember(into, TopicData_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 18: type = only(m, type, 'topicDataRecord'); { const end = r.enter(); m.topicDataRecord = decodeTopicDataRecord(r, m.topicDataRecord); r.end = end; break; }
      case 26: type = only(m, type, 'topicDataRecordList'); { const end = r.enter(); m.topicDataRecordList = decodeTopicDataRecordList(r, m.topicDataRecordList); r.end = end; break; }
      case 34: type = only(m, type, 'error'); { const end = r.enter(); m.error = decodeErrorMessage(r, m.error); r.end = end; break; }
      case 8002: type = only(m, type, 'nodeMessage'); { const end = r.enter(); m.nodeMessage = decodeNodeMessage(r, m.nodeMessage); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataRecord(m: Init<T.TopicDataRecord>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.timestamp != null) { const at = w.open(18); encodeTimestamp(m.timestamp, w); w.close(at); }
  if (m.double != null) w.double(25, m.double);
  if (m.bool != null) w.bool(32, m.bool);
  if (m.string != null) w.string(42, m.string);
  if (m.vector2 != null) { const at = w.open(50); encodeVector2(m.vector2, w); w.close(at); }
  if (m.vector3 != null) { const at = w.open(58); encodeVector3(m.vector3, w); w.close(at); }
  if (m.vector4 != null) { const at = w.open(66); encodeVector4(m.vector4, w); w.close(at); }
  if (m.quaternion != null) { const at = w.open(74); encodeQuaternion(m.quaternion, w); w.close(at); }
  if (m.matrix3x2 != null) { const at = w.open(82); encodeMatrix3x2(m.matrix3x2, w); w.close(at); }
  if (m.matrix4x4 != null) { const at = w.open(90); encodeMatrix4x4(m.matrix4x4, w); w.close(at); }
  if (m.color != null) { const at = w.open(98); encodeColor(m.color, w); w.close(at); }
  if (m.touchEvent != null) { const at = w.open(106); encodeTouchEventMessage(m.touchEvent, w); w.close(at); }
  if (m.keyEvent != null) { const at = w.open(114); encodeKeyEvent(m.keyEvent, w); w.close(at); }
  if (m.mouseEvent != null) { const at = w.open(122); encodeMouseEventMessage(m.mouseEvent, w); w.close(at); }
  if (m.myoEvent != null) { const at = w.open(130); encodeMyoEvent(m.myoEvent, w); w.close(at); }
  if (m.pose2D != null) { const at = w.open(138); encodePose2D(m.pose2D, w); w.close(at); }
  if (m.pose3D != null) { const at = w.open(146); encodePose3D(m.pose3D, w); w.close(at); }
  if (m.object2D != null) { const at = w.open(154); encodeObject2D(m.object2D, w); w.close(at); }
  if (m.object3D != null) { const at = w.open(162); encodeObject3D(m.object3D, w); w.close(at); }
  if (m.object2DList != null) { const at = w.open(170); encodeObject2DList(m.object2DList, w); w.close(at); }
  if (m.object3DList != null) { const at = w.open(178); encodeObject3DList(m.object3DList, w); w.close(at); }
  if (m.int32 != null) w.int32(184, m.int32);
  if (m.float != null) w.float(197, m.float);
  if (m.int32List != null) { const at = w.open(202); encodeInt32List(m.int32List, w); w.close(at); }
  if (m.floatList != null) { const at = w.open(210); encodeFloatList(m.floatList, w); w.close(at); }
  if (m.doubleList != null) { const at = w.open(218); encodeDoubleList(m.doubleList, w); w.close(at); }
  if (m.stringList != null) { const at = w.open(226); encodeStringList(m.stringList, w); w.close(at); }
  if (m.boolList != null) { const at = w.open(234); encodeBoolList(m.boolList, w); w.close(at); }
  if (m.image2D != null) { const at = w.open(242); encodeImage2D(m.image2D, w); w.close(at); }
  if (m.image2DList != null) { const at = w.open(250); encodeImage2DList(m.image2DList, w); w.close(at); }
  if (m.session != null) { const at = w.open(258); encodeSession(m.session, w); w.close(at); }
  if (m.clientId != null) w.string(266, m.clientId);
  if (m.touchEventList != null) { const at = w.open(274); encodeTouchEventList(m.touchEventList, w); w.close(at); }
  if (m.vector2List != null) { const at = w.open(282); encodeVector2List(m.vector2List, w); w.close(at); }
  if (m.vector3List != null) { const at = w.open(290); encodeVector3List(m.vector3List, w); w.close(at); }
  if (m.vector4List != null) { const at = w.open(298); encodeVector4List(m.vector4List, w); w.close(at); }
  if (m.quaternionList != null) { const at = w.open(306); encodeQuaternion(m.quaternionList, w); w.close(at); }
  if (m.error != null) { const at = w.open(314); encodeErrorMessage(m.error, w); w.close(at); }
  if (m.device != null) { const at = w.open(322); encodeDevice(m.device, w); w.close(at); }
  if (m.deviceList != null) { const at = w.open(330); encodeDeviceList(m.deviceList, w); w.close(at); }
  if (m.component != null) { const at = w.open(338); encodeComponent(m.component, w); w.close(at); }
  if (m.componentList != null) { const at = w.open(346); encodeComponentList(m.componentList, w); w.close(at); }
  if (m.sessionList != null) { const at = w.open(354); encodeSessionList(m.sessionList, w); w.close(at); }
  if (m.client != null) { const at = w.open(8002); encodeClient(m.client, w); w.close(at); }
  if (m.sessionStatistics != null) { const at = w.open(8010); encodeSessionStatistics(m.sessionStatistics, w); w.close(at); }
  if (m.moduleEvent != null) { const at = w.open(8018); encodeModuleEvent(m.moduleEvent, w); w.close(at); }
  if (m.extension != null) { const at = w.open(8026); encodeRecordExtension(m.extension, w); w.close(at); }
  if (m.recordingStatus != null) { const at = w.open(8082); encodeRecordingStatus(m.recordingStatus, w); w.close(at); }
}

const TopicDataRecord_type = ['double', 'bool', 'string', 'vector2', 'vector3', 'vector4', 'quaternion', 'matrix3x2', 'matrix4x4', 'color', 'touchEvent', 'keyEvent', 'mouseEvent', 'myoEvent', 'pose2D', 'pose3D', 'object2D', 'object3D', 'object2DList', 'object3DList', 'int32', 'float', 'int32List', 'floatList', 'doubleList', 'stringList', 'boolList', 'image2D', 'image2DList', 'session', 'touchEventList', 'vector2List', 'vector3List', 'vector4List', 'quaternionList', 'error', 'device', 'deviceList', 'component', 'componentList', 'sessionList', 'client', 'sessionStatistics', 'moduleEvent', 'recordingStatus'] as const;
export function decodeTopicDataRecord(r: Reader, into?: T.TopicDataRecord): T.TopicDataRecord {
  const m: T.TopicDataRecord = into ?? { topic: '', timestamp: undefined, clientId: '', extension: undefined };
  let type = into && setMember(into, TopicDataRecord_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: { const end = r.enter(); m.timestamp = decodeTimestamp(r, m.timestamp); r.end = end; break; }
      case 25: type = only(m, type, 'double'); m.double = r.double(); break;
      case 32: type = only(m, type, 'bool'); m.bool = r.bool(); break;
      case 42: type = only(m, type, 'string'); m.string = r.string(); break;
      case 50: type = only(m, type, 'vector2'); { const end = r.enter(); m.vector2 = decodeVector2(r, m.vector2); r.end = end; break; }
      case 58: type = only(m, type, 'vector3'); { const end = r.enter(); m.vector3 = decodeVector3(r, m.vector3); r.end = end; break; }
      case 66: type = only(m, type, 'vector4'); { const end = r.enter(); m.vector4 = decodeVector4(r, m.vector4); r.end = end; break; }
      case 74: type = only(m, type, 'quaternion'); { const end = r.enter(); m.quaternion = decodeQuaternion(r, m.quaternion); r.end = end; break; }
      case 82: type = only(m, type, 'matrix3x2'); { const end = r.enter(); m.matrix3x2 = decodeMatrix3x2(r, m.matrix3x2); r.end = end; break; }
      case 90: type = only(m, type, 'matrix4x4'); { const end = r.enter(); m.matrix4x4 = decodeMatrix4x4(r, m.matrix4x4); r.end = end; break; }
      case 98: type = only(m, type, 'color'); { const end = r.enter(); m.color = decodeColor(r, m.color); r.end = end; break; }
      case 106: type = only(m, type, 'touchEvent'); { const end = r.enter(); m.touchEvent = decodeTouchEventMessage(r, m.touchEvent); r.end = end; break; }
      case 114: type = only(m, type, 'keyEvent'); { const end = r.enter(); m.keyEvent = decodeKeyEvent(r, m.keyEvent); r.end = end; break; }
      case 122: type = only(m, type, 'mouseEvent'); { const end = r.enter(); m.mouseEvent = decodeMouseEventMessage(r, m.mouseEvent); r.end = end; break; }
      case 130: type = only(m, type, 'myoEvent'); { const end = r.enter(); m.myoEvent = decodeMyoEvent(r, m.myoEvent); r.end = end; break; }
      case 138: type = only(m, type, 'pose2D'); { const end = r.enter(); m.pose2D = decodePose2D(r, m.pose2D); r.end = end; break; }
      case 146: type = only(m, type, 'pose3D'); { const end = r.enter(); m.pose3D = decodePose3D(r, m.pose3D); r.end = end; break; }
      case 154: type = only(m, type, 'object2D'); { const end = r.enter(); m.object2D = decodeObject2D(r, m.object2D); r.end = end; break; }
      case 162: type = only(m, type, 'object3D'); { const end = r.enter(); m.object3D = decodeObject3D(r, m.object3D); r.end = end; break; }
      case 170: type = only(m, type, 'object2DList'); { const end = r.enter(); m.object2DList = decodeObject2DList(r, m.object2DList); r.end = end; break; }
      case 178: type = only(m, type, 'object3DList'); { const end = r.enter(); m.object3DList = decodeObject3DList(r, m.object3DList); r.end = end; break; }
      case 184: type = only(m, type, 'int32'); m.int32 = r.int32(); break;
      case 197: type = only(m, type, 'float'); m.float = r.float(); break;
      case 202: type = only(m, type, 'int32List'); { const end = r.enter(); m.int32List = decodeInt32List(r, m.int32List); r.end = end; break; }
      case 210: type = only(m, type, 'floatList'); { const end = r.enter(); m.floatList = decodeFloatList(r, m.floatList); r.end = end; break; }
      case 218: type = only(m, type, 'doubleList'); { const end = r.enter(); m.doubleList = decodeDoubleList(r, m.doubleList); r.end = end; break; }
      case 226: type = only(m, type, 'stringList'); { const end = r.enter(); m.stringList = decodeStringList(r, m.stringList); r.end = end; break; }
      case 234: type = only(m, type, 'boolList'); { const end = r.enter(); m.boolList = decodeBoolList(r, m.boolList); r.end = end; break; }
      case 242: type = only(m, type, 'image2D'); { const end = r.enter(); m.image2D = decodeImage2D(r, m.image2D); r.end = end; break; }
      case 250: type = only(m, type, 'image2DList'); { const end = r.enter(); m.image2DList = decodeImage2DList(r, m.image2DList); r.end = end; break; }
      case 258: type = only(m, type, 'session'); { const end = r.enter(); m.session = decodeSession(r, m.session); r.end = end; break; }
      case 266: m.clientId = r.string(); break;
      case 274: type = only(m, type, 'touchEventList'); { const end = r.enter(); m.touchEventList = decodeTouchEventList(r, m.touchEventList); r.end = end; break; }
      case 282: type = only(m, type, 'vector2List'); { const end = r.enter(); m.vector2List = decodeVector2List(r, m.vector2List); r.end = end; break; }
      case 290: type = only(m, type, 'vector3List'); { const end = r.enter(); m.vector3List = decodeVector3List(r, m.vector3List); r.end = end; break; }
      case 298: type = only(m, type, 'vector4List'); { const end = r.enter(); m.vector4List = decodeVector4List(r, m.vector4List); r.end = end; break; }
      case 306: type = only(m, type, 'quaternionList'); { const end = r.enter(); m.quaternionList = decodeQuaternion(r, m.quaternionList); r.end = end; break; }
      case 314: type = only(m, type, 'error'); { const end = r.enter(); m.error = decodeErrorMessage(r, m.error); r.end = end; break; }
      case 322: type = only(m, type, 'device'); { const end = r.enter(); m.device = decodeDevice(r, m.device); r.end = end; break; }
      case 330: type = only(m, type, 'deviceList'); { const end = r.enter(); m.deviceList = decodeDeviceList(r, m.deviceList); r.end = end; break; }
      case 338: type = only(m, type, 'component'); { const end = r.enter(); m.component = decodeComponent(r, m.component); r.end = end; break; }
      case 346: type = only(m, type, 'componentList'); { const end = r.enter(); m.componentList = decodeComponentList(r, m.componentList); r.end = end; break; }
      case 354: type = only(m, type, 'sessionList'); { const end = r.enter(); m.sessionList = decodeSessionList(r, m.sessionList); r.end = end; break; }
      case 8002: type = only(m, type, 'client'); { const end = r.enter(); m.client = decodeClient(r, m.client); r.end = end; break; }
      case 8010: type = only(m, type, 'sessionStatistics'); { const end = r.enter(); m.sessionStatistics = decodeSessionStatistics(r, m.sessionStatistics); r.end = end; break; }
      case 8018: type = only(m, type, 'moduleEvent'); { const end = r.enter(); m.moduleEvent = decodeModuleEvent(r, m.moduleEvent); r.end = end; break; }
      case 8026: { const end = r.enter(); m.extension = decodeRecordExtension(r, m.extension); r.end = end; break; }
      case 8082: type = only(m, type, 'recordingStatus'); { const end = r.enter(); m.recordingStatus = decodeRecordingStatus(r, m.recordingStatus); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataRecordList(m: Init<T.TopicDataRecordList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicDataRecord(e, w); w.close(at); }
}

export function decodeTopicDataRecordList(r: Reader, into?: T.TopicDataRecordList): T.TopicDataRecordList {
  const m: T.TopicDataRecordList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicDataRecord(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataSource(m: Init<T.TopicDataSource>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.regex != null) w.string(18, m.regex);
  if (m.component != null) { const at = w.open(26); encodeComponent(m.component, w); w.close(at); }
  if (m.staticRecord != null) { const at = w.open(34); encodeTopicDataRecord(m.staticRecord, w); w.close(at); }
}

const TopicDataSource_type = ['topic', 'regex', 'component', 'staticRecord'] as const;
export function decodeTopicDataSource(r: Reader, into?: T.TopicDataSource): T.TopicDataSource {
  const m: T.TopicDataSource = into ?? {};
  let type = into && setMember(into, TopicDataSource_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: type = only(m, type, 'topic'); m.topic = r.string(); break;
      case 18: type = only(m, type, 'regex'); m.regex = r.string(); break;
      case 26: type = only(m, type, 'component'); { const end = r.enter(); m.component = decodeComponent(r, m.component); r.end = end; break; }
      case 34: type = only(m, type, 'staticRecord'); { const end = r.enter(); m.staticRecord = decodeTopicDataRecord(r, m.staticRecord); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeTopicDataSourceList(m: Init<T.TopicDataSourceList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeTopicDataSource(e, w); w.close(at); }
}

export function decodeTopicDataSourceList(r: Reader, into?: T.TopicDataSourceList): T.TopicDataSourceList {
  const m: T.TopicDataSourceList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeTopicDataSource(r)); r.end = end; break; }
      default: skipField(r, tag);
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
  'ubii.extension.AccessGrant': { encode: encodeAccessGrant, decode: decodeAccessGrant },
  'ubii.extension.AccessGrantCreateRequest': { encode: encodeAccessGrantCreateRequest, decode: decodeAccessGrantCreateRequest },
  'ubii.extension.AccessGrantCreated': { encode: encodeAccessGrantCreated, decode: decodeAccessGrantCreated },
  'ubii.extension.AccessGrantList': { encode: encodeAccessGrantList, decode: decodeAccessGrantList },
  'ubii.extension.AccessGrantRevokeRequest': { encode: encodeAccessGrantRevokeRequest, decode: decodeAccessGrantRevokeRequest },
  'ubii.extension.AssetSet': { encode: encodeAssetSet, decode: decodeAssetSet },
  'ubii.extension.AssetSetDownload': { encode: encodeAssetSetDownload, decode: decodeAssetSetDownload },
  'ubii.extension.AssetSetList': { encode: encodeAssetSetList, decode: decodeAssetSetList },
  'ubii.extension.AssetSetRequest': { encode: encodeAssetSetRequest, decode: decodeAssetSetRequest },
  'ubii.extension.AuditEntry': { encode: encodeAuditEntry, decode: decodeAuditEntry },
  'ubii.extension.AuditLog': { encode: encodeAuditLog, decode: decodeAuditLog },
  'ubii.extension.AuditLogRequest': { encode: encodeAuditLogRequest, decode: decodeAuditLogRequest },
  'ubii.extension.ClientActivity': { encode: encodeClientActivity, decode: decodeClientActivity },
  'ubii.extension.ClientClock': { encode: encodeClientClock, decode: decodeClientClock },
  'ubii.extension.ClientDisconnectRequest': { encode: encodeClientDisconnectRequest, decode: decodeClientDisconnectRequest },
  'ubii.extension.ClientExtension': { encode: encodeClientExtension, decode: decodeClientExtension },
  'ubii.extension.ClientRenameRequest': { encode: encodeClientRenameRequest, decode: decodeClientRenameRequest },
  'ubii.extension.ClientReport': { encode: encodeClientReport, decode: decodeClientReport },
  'ubii.extension.ClientReportRequest': { encode: encodeClientReportRequest, decode: decodeClientReportRequest },
  'ubii.extension.ClientSubscription': { encode: encodeClientSubscription, decode: decodeClientSubscription },
  'ubii.extension.ClientThrottle': { encode: encodeClientThrottle, decode: decodeClientThrottle },
  'ubii.extension.ClientThrottleRequest': { encode: encodeClientThrottleRequest, decode: decodeClientThrottleRequest },
  'ubii.extension.EndedTopics': { encode: encodeEndedTopics, decode: decodeEndedTopics },
  'ubii.extension.FlightRecorder': { encode: encodeFlightRecorder, decode: decodeFlightRecorder },
  'ubii.extension.FlightRecorderKeepRequest': { encode: encodeFlightRecorderKeepRequest, decode: decodeFlightRecorderKeepRequest },
  'ubii.extension.FlightRecorderSettings': { encode: encodeFlightRecorderSettings, decode: decodeFlightRecorderSettings },
  'ubii.extension.JoinCheck': { encode: encodeJoinCheck, decode: decodeJoinCheck },
  'ubii.extension.JoinCheckRequest': { encode: encodeJoinCheckRequest, decode: decodeJoinCheckRequest },
  'ubii.extension.JoinRefusal': { encode: encodeJoinRefusal, decode: decodeJoinRefusal },
  'ubii.extension.Limit': { encode: encodeLimit, decode: decodeLimit },
  'ubii.extension.LimitList': { encode: encodeLimitList, decode: decodeLimitList },
  'ubii.extension.LimitUse': { encode: encodeLimitUse, decode: decodeLimitUse },
  'ubii.extension.LogField': { encode: encodeLogField, decode: decodeLogField },
  'ubii.extension.LogLine': { encode: encodeLogLine, decode: decodeLogLine },
  'ubii.extension.LogRequest': { encode: encodeLogRequest, decode: decodeLogRequest },
  'ubii.extension.LogTail': { encode: encodeLogTail, decode: decodeLogTail },
  'ubii.extension.MasterAddress': { encode: encodeMasterAddress, decode: decodeMasterAddress },
  'ubii.extension.MasterStatus': { encode: encodeMasterStatus, decode: decodeMasterStatus },
  'ubii.extension.MasterStatusRequest': { encode: encodeMasterStatusRequest, decode: decodeMasterStatusRequest },
  'ubii.extension.ModuleEvent': { encode: encodeModuleEvent, decode: decodeModuleEvent },
  'ubii.extension.ModuleExtension': { encode: encodeModuleExtension, decode: decodeModuleExtension },
  'ubii.extension.ModuleReports': { encode: encodeModuleReports, decode: decodeModuleReports },
  'ubii.extension.ModuleStatistics': { encode: encodeModuleStatistics, decode: decodeModuleStatistics },
  'ubii.extension.ModuleVersion': { encode: encodeModuleVersion, decode: decodeModuleVersion },
  'ubii.extension.ModuleVersionList': { encode: encodeModuleVersionList, decode: decodeModuleVersionList },
  'ubii.extension.ModuleVersionRequest': { encode: encodeModuleVersionRequest, decode: decodeModuleVersionRequest },
  'ubii.extension.NodeExtension': { encode: encodeNodeExtension, decode: decodeNodeExtension },
  'ubii.extension.NodeInfo': { encode: encodeNodeInfo, decode: decodeNodeInfo },
  'ubii.extension.NodeList': { encode: encodeNodeList, decode: decodeNodeList },
  'ubii.extension.NodeMessage': { encode: encodeNodeMessage, decode: decodeNodeMessage },
  'ubii.extension.RecordExtension': { encode: encodeRecordExtension, decode: decodeRecordExtension },
  'ubii.extension.Recording': { encode: encodeRecording, decode: decodeRecording },
  'ubii.extension.RecordingBudget': { encode: encodeRecordingBudget, decode: decodeRecordingBudget },
  'ubii.extension.RecordingChangeRequest': { encode: encodeRecordingChangeRequest, decode: decodeRecordingChangeRequest },
  'ubii.extension.RecordingEstimate': { encode: encodeRecordingEstimate, decode: decodeRecordingEstimate },
  'ubii.extension.RecordingList': { encode: encodeRecordingList, decode: decodeRecordingList },
  'ubii.extension.RecordingMarker': { encode: encodeRecordingMarker, decode: decodeRecordingMarker },
  'ubii.extension.RecordingRequest': { encode: encodeRecordingRequest, decode: decodeRecordingRequest },
  'ubii.extension.RecordingSelection': { encode: encodeRecordingSelection, decode: decodeRecordingSelection },
  'ubii.extension.RecordingStartRequest': { encode: encodeRecordingStartRequest, decode: decodeRecordingStartRequest },
  'ubii.extension.RecordingStatus': { encode: encodeRecordingStatus, decode: decodeRecordingStatus },
  'ubii.extension.RecordingTopic': { encode: encodeRecordingTopic, decode: decodeRecordingTopic },
  'ubii.extension.RecordingTopicRate': { encode: encodeRecordingTopicRate, decode: decodeRecordingTopicRate },
  'ubii.extension.SessionExtension': { encode: encodeSessionExtension, decode: decodeSessionExtension },
  'ubii.extension.SessionProblem': { encode: encodeSessionProblem, decode: decodeSessionProblem },
  'ubii.extension.SessionStatistics': { encode: encodeSessionStatistics, decode: decodeSessionStatistics },
  'ubii.extension.Setting': { encode: encodeSetting, decode: decodeSetting },
  'ubii.extension.SettingList': { encode: encodeSettingList, decode: decodeSettingList },
  'ubii.extension.StatusEvent': { encode: encodeStatusEvent, decode: decodeStatusEvent },
  'ubii.extension.StatusProblem': { encode: encodeStatusProblem, decode: decodeStatusProblem },
  'ubii.extension.StatusSample': { encode: encodeStatusSample, decode: decodeStatusSample },
  'ubii.extension.SubscribedModule': { encode: encodeSubscribedModule, decode: decodeSubscribedModule },
  'ubii.extension.TopicStatistic': { encode: encodeTopicStatistic, decode: decodeTopicStatistic },
  'ubii.extension.TopicStatistics': { encode: encodeTopicStatistics, decode: decodeTopicStatistics },
  'ubii.extension.TopicStatisticsRequest': { encode: encodeTopicStatisticsRequest, decode: decodeTopicStatisticsRequest },
  'ubii.extension.TopicSubscribers': { encode: encodeTopicSubscribers, decode: decodeTopicSubscribers },
  'ubii.extension.TopicSubscribersList': { encode: encodeTopicSubscribersList, decode: decodeTopicSubscribersList },
  'ubii.extension.TopicSubscribersRequest': { encode: encodeTopicSubscribersRequest, decode: decodeTopicSubscribersRequest },
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
