// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.

import { only, setMember } from '../binary/oneof.ts';
import type { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import type { Writer } from '../binary/writer.ts';
import type { Init } from '../init.ts';
import { tableCodec, type CodecOf } from '../table-codec.ts';
import type * as T from './messages.ts';

const Client = tableCodec('ubii.clients.Client');
const Component = tableCodec('ubii.devices.Component');
const ComponentList = tableCodec('ubii.devices.ComponentList');
const Device = tableCodec('ubii.devices.Device');
const DeviceList = tableCodec('ubii.devices.DeviceList');
const ModuleEvent = tableCodec('ubii.extension.ModuleEvent');
const ModuleReports = tableCodec('ubii.extension.ModuleReports');
const RecordingStatus = tableCodec('ubii.extension.RecordingStatus');
const SessionStatistics = tableCodec('ubii.extension.SessionStatistics');
const Session = tableCodec('ubii.sessions.Session');
const SessionList = tableCodec('ubii.sessions.SessionList');

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

export function encodeBridgeAnswer(m: Init<T.BridgeAnswer>, w: Writer): void {
  if (m.number != null) w.int32(8, m.number);
  if (m.mappings != null) { const at = w.open(18); encodeBridgeMappings(m.mappings, w); w.close(at); }
  if (m.error != null) { const at = w.open(26); encodeErrorMessage(m.error, w); w.close(at); }
}

export function decodeBridgeAnswer(r: Reader, into?: T.BridgeAnswer): T.BridgeAnswer {
  const m: T.BridgeAnswer = into ?? { number: 0, mappings: undefined, error: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.number = r.int32(); break;
      case 18: { const end = r.enter(); m.mappings = decodeBridgeMappings(r, m.mappings); r.end = end; break; }
      case 26: { const end = r.enter(); m.error = decodeErrorMessage(r, m.error); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBridgeMappingProblem(m: Init<T.BridgeMappingProblem>, w: Writer): void {
  if (m.index != null) w.int32(8, m.index);
  if (m.member != null) w.string(18, m.member);
  if (m.message != null) w.string(26, m.message);
}

export function decodeBridgeMappingProblem(r: Reader, into?: T.BridgeMappingProblem): T.BridgeMappingProblem {
  const m: T.BridgeMappingProblem = into ?? { index: 0, member: '', message: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.index = r.int32(); break;
      case 18: m.member = r.string(); break;
      case 26: m.message = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBridgeMappings(m: Init<T.BridgeMappings>, w: Writer): void {
  if (m.protocol != null) w.string(10, m.protocol);
  if (m.mappingsJson != null) w.string(18, m.mappingsJson);
  if (m.revision != null) w.string(26, m.revision);
  if (m.file != null) w.string(34, m.file);
  if (m.fileExists != null) w.bool(40, m.fileExists);
  if (m.fileProblem != null) w.string(50, m.fileProblem);
  if (m.outcome != null) w.int32(56, m.outcome);
  if (m.problems != null) for (const e of m.problems) { const at = w.open(66); encodeBridgeMappingProblem(e, w); w.close(at); }
  if (m.matches != null) for (const e of m.matches) { const at = w.open(74); encodeBridgeMatch(e, w); w.close(at); }
  if (m.moreMatches != null) w.int32(80, m.moreMatches);
}

export function decodeBridgeMappings(r: Reader, into?: T.BridgeMappings): T.BridgeMappings {
  const m: T.BridgeMappings = into ?? { protocol: '', mappingsJson: '', revision: '', file: '', fileExists: false, fileProblem: '', outcome: 0, problems: [], matches: [], moreMatches: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.protocol = r.string(); break;
      case 18: m.mappingsJson = r.string(); break;
      case 26: m.revision = r.string(); break;
      case 34: m.file = r.string(); break;
      case 40: m.fileExists = r.bool(); break;
      case 50: m.fileProblem = r.string(); break;
      case 56: m.outcome = r.int32() as T.BridgeOutcome; break;
      case 66: { const end = r.enter(); m.problems.push(decodeBridgeMappingProblem(r)); r.end = end; break; }
      case 74: { const end = r.enter(); m.matches.push(decodeBridgeMatch(r)); r.end = end; break; }
      case 80: m.moreMatches = r.int32(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBridgeMappingsChange(m: Init<T.BridgeMappingsChange>, w: Writer): void {
  if (m.targetId != null) w.string(10, m.targetId);
  if (m.mappingsJson != null) w.string(18, m.mappingsJson);
  if (m.revision != null) w.string(26, m.revision);
  if (m.previewIndex != null) w.int32(32, m.previewIndex);
  if (m.clientId != null) w.string(42, m.clientId);
}

export function decodeBridgeMappingsChange(r: Reader, into?: T.BridgeMappingsChange): T.BridgeMappingsChange {
  const m: T.BridgeMappingsChange = into ?? { targetId: '', mappingsJson: '', revision: '', previewIndex: 0, clientId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.targetId = r.string(); break;
      case 18: m.mappingsJson = r.string(); break;
      case 26: m.revision = r.string(); break;
      case 32: m.previewIndex = r.int32(); break;
      case 42: m.clientId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBridgeMappingsRequest(m: Init<T.BridgeMappingsRequest>, w: Writer): void {
  if (m.targetId != null) w.string(10, m.targetId);
}

export function decodeBridgeMappingsRequest(r: Reader, into?: T.BridgeMappingsRequest): T.BridgeMappingsRequest {
  const m: T.BridgeMappingsRequest = into ?? { targetId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.targetId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBridgeMatch(m: Init<T.BridgeMatch>, w: Writer): void {
  if (m.inward != null) w.bool(8, m.inward);
  if (m.source != null) w.string(18, m.source);
  if (m.target != null) w.string(26, m.target);
  if (m.isExample != null) w.bool(32, m.isExample);
}

export function decodeBridgeMatch(r: Reader, into?: T.BridgeMatch): T.BridgeMatch {
  const m: T.BridgeMatch = into ?? { inward: false, source: '', target: '', isExample: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.inward = r.bool(); break;
      case 18: m.source = r.string(); break;
      case 26: m.target = r.string(); break;
      case 32: m.isExample = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeBridgeOrder(m: Init<T.BridgeOrder>, w: Writer): void {
  if (m.number != null) w.int32(8, m.number);
  if (m.get != null) { const at = w.open(18); encodeBridgeMappingsRequest(m.get, w); w.close(at); }
  if (m.check != null) { const at = w.open(26); encodeBridgeMappingsChange(m.check, w); w.close(at); }
  if (m.set != null) { const at = w.open(34); encodeBridgeMappingsChange(m.set, w); w.close(at); }
  if (m.author != null) w.string(42, m.author);
}

const BridgeOrder_type = ['get', 'check', 'set'] as const;
export function decodeBridgeOrder(r: Reader, into?: T.BridgeOrder): T.BridgeOrder {
  const m: T.BridgeOrder = into ?? { number: 0, author: '' };
  let type = into && setMember(into, BridgeOrder_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.number = r.int32(); break;
      case 18: type = only(m, type, 'get'); { const end = r.enter(); m.get = decodeBridgeMappingsRequest(r, m.get); r.end = end; break; }
      case 26: type = only(m, type, 'check'); { const end = r.enter(); m.check = decodeBridgeMappingsChange(r, m.check); r.end = end; break; }
      case 34: type = only(m, type, 'set'); { const end = r.enter(); m.set = decodeBridgeMappingsChange(r, m.set); r.end = end; break; }
      case 42: m.author = r.string(); break;
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

export function encodeNodeMessage(m: Init<T.NodeMessage>, w: Writer): void {
  if (m.lockstepRequest != null) { const at = w.open(10); encodeLockstepProcessingRequest(m.lockstepRequest, w); w.close(at); }
  if (m.lockstepReply != null) { const at = w.open(18); encodeLockstepProcessingReply(m.lockstepReply, w); w.close(at); }
  if (m.moduleReports != null) { const at = w.open(26); ModuleReports.encode(m.moduleReports, w); w.close(at); }
  if (m.endedTopics != null) { const at = w.open(34); encodeEndedTopics(m.endedTopics, w); w.close(at); }
  if (m.recorderOrder != null) { const at = w.open(42); encodeNodeRecorderOrder(m.recorderOrder, w); w.close(at); }
  if (m.recorderAnswer != null) { const at = w.open(50); encodeNodeRecorderAnswer(m.recorderAnswer, w); w.close(at); }
  if (m.recorderReport != null) { const at = w.open(58); encodeNodeRecorderReport(m.recorderReport, w); w.close(at); }
  if (m.bridgeOrder != null) { const at = w.open(66); encodeBridgeOrder(m.bridgeOrder, w); w.close(at); }
  if (m.bridgeAnswer != null) { const at = w.open(74); encodeBridgeAnswer(m.bridgeAnswer, w); w.close(at); }
}

const NodeMessage_type = ['lockstepRequest', 'lockstepReply', 'moduleReports', 'endedTopics', 'recorderOrder', 'recorderAnswer', 'recorderReport', 'bridgeOrder', 'bridgeAnswer'] as const;
export function decodeNodeMessage(r: Reader, into?: T.NodeMessage): T.NodeMessage {
  const m: T.NodeMessage = into ?? {};
  let type = into && setMember(into, NodeMessage_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: type = only(m, type, 'lockstepRequest'); { const end = r.enter(); m.lockstepRequest = decodeLockstepProcessingRequest(r, m.lockstepRequest); r.end = end; break; }
      case 18: type = only(m, type, 'lockstepReply'); { const end = r.enter(); m.lockstepReply = decodeLockstepProcessingReply(r, m.lockstepReply); r.end = end; break; }
      case 26: type = only(m, type, 'moduleReports'); { const end = r.enter(); m.moduleReports = ModuleReports.decode(r, m.moduleReports); r.end = end; break; }
      case 34: type = only(m, type, 'endedTopics'); { const end = r.enter(); m.endedTopics = decodeEndedTopics(r, m.endedTopics); r.end = end; break; }
      case 42: type = only(m, type, 'recorderOrder'); { const end = r.enter(); m.recorderOrder = decodeNodeRecorderOrder(r, m.recorderOrder); r.end = end; break; }
      case 50: type = only(m, type, 'recorderAnswer'); { const end = r.enter(); m.recorderAnswer = decodeNodeRecorderAnswer(r, m.recorderAnswer); r.end = end; break; }
      case 58: type = only(m, type, 'recorderReport'); { const end = r.enter(); m.recorderReport = decodeNodeRecorderReport(r, m.recorderReport); r.end = end; break; }
      case 66: type = only(m, type, 'bridgeOrder'); { const end = r.enter(); m.bridgeOrder = decodeBridgeOrder(r, m.bridgeOrder); r.end = end; break; }
      case 74: type = only(m, type, 'bridgeAnswer'); { const end = r.enter(); m.bridgeAnswer = decodeBridgeAnswer(r, m.bridgeAnswer); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderAnswer(m: Init<T.NodeRecorderAnswer>, w: Writer): void {
  if (m.number != null) w.int32(8, m.number);
  if (m.recording != null) { const at = w.open(18); encodeRecording(m.recording, w); w.close(at); }
  if (m.marker != null) { const at = w.open(26); encodeRecordingMarker(m.marker, w); w.close(at); }
  if (m.error != null) { const at = w.open(34); encodeErrorMessage(m.error, w); w.close(at); }
}

export function decodeNodeRecorderAnswer(r: Reader, into?: T.NodeRecorderAnswer): T.NodeRecorderAnswer {
  const m: T.NodeRecorderAnswer = into ?? { number: 0, recording: undefined, marker: undefined, error: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.number = r.int32(); break;
      case 18: { const end = r.enter(); m.recording = decodeRecording(r, m.recording); r.end = end; break; }
      case 26: { const end = r.enter(); m.marker = decodeRecordingMarker(r, m.marker); r.end = end; break; }
      case 34: { const end = r.enter(); m.error = decodeErrorMessage(r, m.error); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderClock(m: Init<T.NodeRecorderClock>, w: Writer): void {
  if (m.clientId != null) w.string(10, m.clientId);
  if (m.clock != null) { const at = w.open(18); encodeClientClock(m.clock, w); w.close(at); }
}

export function decodeNodeRecorderClock(r: Reader, into?: T.NodeRecorderClock): T.NodeRecorderClock {
  const m: T.NodeRecorderClock = into ?? { clientId: '', clock: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.clientId = r.string(); break;
      case 18: { const end = r.enter(); m.clock = decodeClientClock(r, m.clock); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderFacts(m: Init<T.NodeRecorderFacts>, w: Writer): void {
  if (m.clocks != null) for (const e of m.clocks) { const at = w.open(10); encodeNodeRecorderClock(e, w); w.close(at); }
  if (m.lostCount != null) w.double(17, m.lostCount);
  if (m.lostFromMs != null) w.double(25, m.lostFromMs);
  if (m.lostUntilMs != null) w.double(33, m.lostUntilMs);
}

export function decodeNodeRecorderFacts(r: Reader, into?: T.NodeRecorderFacts): T.NodeRecorderFacts {
  const m: T.NodeRecorderFacts = into ?? { clocks: [], lostCount: 0, lostFromMs: 0, lostUntilMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.clocks.push(decodeNodeRecorderClock(r)); r.end = end; break; }
      case 17: m.lostCount = r.double(); break;
      case 25: m.lostFromMs = r.double(); break;
      case 33: m.lostUntilMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderMark(m: Init<T.NodeRecorderMark>, w: Writer): void {
  if (m.marker != null) { const at = w.open(10); encodeRecordingMarker(m.marker, w); w.close(at); }
  if (m.mayChangeAll != null) w.bool(16, m.mayChangeAll);
  if (m.isTopic != null) w.bool(24, m.isTopic);
}

export function decodeNodeRecorderMark(r: Reader, into?: T.NodeRecorderMark): T.NodeRecorderMark {
  const m: T.NodeRecorderMark = into ?? { marker: undefined, mayChangeAll: false, isTopic: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.marker = decodeRecordingMarker(r, m.marker); r.end = end; break; }
      case 16: m.mayChangeAll = r.bool(); break;
      case 24: m.isTopic = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderOrder(m: Init<T.NodeRecorderOrder>, w: Writer): void {
  if (m.number != null) w.int32(8, m.number);
  if (m.start != null) { const at = w.open(18); encodeNodeRecorderStart(m.start, w); w.close(at); }
  if (m.stop != null) { const at = w.open(26); encodeRecordingRequest(m.stop, w); w.close(at); }
  if (m.get != null) { const at = w.open(34); encodeRecordingRequest(m.get, w); w.close(at); }
  if (m.change != null) { const at = w.open(42); encodeRecordingChangeRequest(m.change, w); w.close(at); }
  if (m.remove != null) { const at = w.open(50); encodeRecordingRequest(m.remove, w); w.close(at); }
  if (m.mark != null) { const at = w.open(58); encodeNodeRecorderMark(m.mark, w); w.close(at); }
  if (m.upload != null) { const at = w.open(66); encodeRecordingRequest(m.upload, w); w.close(at); }
  if (m.sources != null) { const at = w.open(74); encodeNodeRecorderSources(m.sources, w); w.close(at); }
  if (m.facts != null) { const at = w.open(82); encodeNodeRecorderFacts(m.facts, w); w.close(at); }
}

const NodeRecorderOrder_type = ['start', 'stop', 'get', 'change', 'remove', 'mark', 'upload', 'sources', 'facts'] as const;
export function decodeNodeRecorderOrder(r: Reader, into?: T.NodeRecorderOrder): T.NodeRecorderOrder {
  const m: T.NodeRecorderOrder = into ?? { number: 0 };
  let type = into && setMember(into, NodeRecorderOrder_type);
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.number = r.int32(); break;
      case 18: type = only(m, type, 'start'); { const end = r.enter(); m.start = decodeNodeRecorderStart(r, m.start); r.end = end; break; }
      case 26: type = only(m, type, 'stop'); { const end = r.enter(); m.stop = decodeRecordingRequest(r, m.stop); r.end = end; break; }
      case 34: type = only(m, type, 'get'); { const end = r.enter(); m.get = decodeRecordingRequest(r, m.get); r.end = end; break; }
      case 42: type = only(m, type, 'change'); { const end = r.enter(); m.change = decodeRecordingChangeRequest(r, m.change); r.end = end; break; }
      case 50: type = only(m, type, 'remove'); { const end = r.enter(); m.remove = decodeRecordingRequest(r, m.remove); r.end = end; break; }
      case 58: type = only(m, type, 'mark'); { const end = r.enter(); m.mark = decodeNodeRecorderMark(r, m.mark); r.end = end; break; }
      case 66: type = only(m, type, 'upload'); { const end = r.enter(); m.upload = decodeRecordingRequest(r, m.upload); r.end = end; break; }
      case 74: type = only(m, type, 'sources'); { const end = r.enter(); m.sources = decodeNodeRecorderSources(r, m.sources); r.end = end; break; }
      case 82: type = only(m, type, 'facts'); { const end = r.enter(); m.facts = decodeNodeRecorderFacts(r, m.facts); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderReport(m: Init<T.NodeRecorderReport>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeRecording(e, w); w.close(at); }
}

export function decodeNodeRecorderReport(r: Reader, into?: T.NodeRecorderReport): T.NodeRecorderReport {
  const m: T.NodeRecorderReport = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeRecording(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderSource(m: Init<T.NodeRecorderSource>, w: Writer): void {
  if (m.topic != null) w.string(10, m.topic);
  if (m.clientId != null) w.string(18, m.clientId);
}

export function decodeNodeRecorderSource(r: Reader, into?: T.NodeRecorderSource): T.NodeRecorderSource {
  const m: T.NodeRecorderSource = into ?? { topic: '', clientId: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.topic = r.string(); break;
      case 18: m.clientId = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderSources(m: Init<T.NodeRecorderSources>, w: Writer): void {
  if (m.recordingId != null) w.string(10, m.recordingId);
  if (m.elements != null) for (const e of m.elements) { const at = w.open(18); encodeNodeRecorderSource(e, w); w.close(at); }
}

export function decodeNodeRecorderSources(r: Reader, into?: T.NodeRecorderSources): T.NodeRecorderSources {
  const m: T.NodeRecorderSources = into ?? { recordingId: '', elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.recordingId = r.string(); break;
      case 18: { const end = r.enter(); m.elements.push(decodeNodeRecorderSource(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeNodeRecorderStart(m: Init<T.NodeRecorderStart>, w: Writer): void {
  if (m.recording != null) { const at = w.open(10); encodeRecording(m.recording, w); w.close(at); }
  if (m.makerId != null) w.string(18, m.makerId);
  if (m.masterName != null) w.string(26, m.masterName);
  if (m.version != null) w.string(34, m.version);
  if (m.personalData != null) w.string(42, m.personalData);
  if (m.sources != null) { const at = w.open(50); encodeNodeRecorderSources(m.sources, w); w.close(at); }
  if (m.facts != null) { const at = w.open(58); encodeNodeRecorderFacts(m.facts, w); w.close(at); }
}

export function decodeNodeRecorderStart(r: Reader, into?: T.NodeRecorderStart): T.NodeRecorderStart {
  const m: T.NodeRecorderStart = into ?? { recording: undefined, makerId: '', masterName: '', version: '', personalData: '', sources: undefined, facts: undefined };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.recording = decodeRecording(r, m.recording); r.end = end; break; }
      case 18: m.makerId = r.string(); break;
      case 26: m.masterName = r.string(); break;
      case 34: m.version = r.string(); break;
      case 42: m.personalData = r.string(); break;
      case 50: { const end = r.enter(); m.sources = decodeNodeRecorderSources(r, m.sources); r.end = end; break; }
      case 58: { const end = r.enter(); m.facts = decodeNodeRecorderFacts(r, m.facts); r.end = end; break; }
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
  if (m.replayedRecordingId != null) w.string(154, m.replayedRecordingId);
  if (m.nodeId != null) w.string(162, m.nodeId);
  if (m.nodeName != null) w.string(170, m.nodeName);
  if (m.nodeIsAway != null) w.bool(176, m.nodeIsAway);
  if (m.uploadedBytes != null) w.double(185, m.uploadedBytes);
  if (m.topicsFrom != null) w.int32(192, m.topicsFrom);
  if (m.topicsTotal != null) w.int32(200, m.topicsTotal);
  if (m.markersFrom != null) w.int32(208, m.markersFrom);
  if (m.study != null) { const at = w.open(242); encodeRecordingStudy(m.study, w); w.close(at); }
}

export function decodeRecording(r: Reader, into?: T.Recording): T.Recording {
  const m: T.Recording = into ?? { id: '', name: '', kind: 0, state: 0, startedMs: 0, durationMs: 0, sizeBytes: 0, recordCount: 0, lostCount: 0, topicCount: 0, markerCount: 0, problem: '', notes: '', author: '', selection: undefined, budget: undefined, topics: [], markers: [], replayedRecordingId: '', nodeId: '', nodeName: '', nodeIsAway: false, uploadedBytes: 0, topicsFrom: 0, topicsTotal: 0, markersFrom: 0, study: undefined };
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
      case 154: m.replayedRecordingId = r.string(); break;
      case 162: m.nodeId = r.string(); break;
      case 170: m.nodeName = r.string(); break;
      case 176: m.nodeIsAway = r.bool(); break;
      case 185: m.uploadedBytes = r.double(); break;
      case 192: m.topicsFrom = r.int32(); break;
      case 200: m.topicsTotal = r.int32(); break;
      case 208: m.markersFrom = r.int32(); break;
      case 242: { const end = r.enter(); m.study = decodeRecordingStudy(r, m.study); r.end = end; break; }
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
  if (m.topicsFrom != null) w.int32(16, m.topicsFrom);
  if (m.markersFrom != null) w.int32(24, m.markersFrom);
}

export function decodeRecordingRequest(r: Reader, into?: T.RecordingRequest): T.RecordingRequest {
  const m: T.RecordingRequest = into ?? { id: '', topicsFrom: 0, markersFrom: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 16: m.topicsFrom = r.int32(); break;
      case 24: m.markersFrom = r.int32(); break;
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

export function encodeRecordingStudy(m: Init<T.RecordingStudy>, w: Writer): void {
  if (m.studyId != null) w.string(10, m.studyId);
  if (m.studyName != null) w.string(18, m.studyName);
  if (m.runId != null) w.string(26, m.runId);
  if (m.participantCode != null) w.string(34, m.participantCode);
  if (m.visit != null) w.string(42, m.visit);
  if (m.condition != null) w.string(50, m.condition);
  if (m.block != null) w.int32(56, m.block);
  if (m.runNumber != null) w.int32(64, m.runNumber);
}

export function decodeRecordingStudy(r: Reader, into?: T.RecordingStudy): T.RecordingStudy {
  const m: T.RecordingStudy = into ?? { studyId: '', studyName: '', runId: '', participantCode: '', visit: '', condition: '', block: 0, runNumber: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.studyId = r.string(); break;
      case 18: m.studyName = r.string(); break;
      case 26: m.runId = r.string(); break;
      case 34: m.participantCode = r.string(); break;
      case 42: m.visit = r.string(); break;
      case 50: m.condition = r.string(); break;
      case 56: m.block = r.int32(); break;
      case 64: m.runNumber = r.int32(); break;
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

export function encodeReplay(m: Init<T.Replay>, w: Writer): void {
  if (m.id != null) w.string(10, m.id);
  if (m.name != null) w.string(18, m.name);
  if (m.recordingId != null) w.string(26, m.recordingId);
  if (m.recordingName != null) w.string(34, m.recordingName);
  if (m.author != null) w.string(42, m.author);
  if (m.state != null) w.int32(48, m.state);
  if (m.positionMs != null) w.double(57, m.positionMs);
  if (m.durationMs != null) w.double(65, m.durationMs);
  if (m.rate != null) w.double(73, m.rate);
  if (m.span != null) { const at = w.open(82); encodeReplaySpan(m.span, w); w.close(at); }
  if (m.isLooping != null) w.bool(88, m.isLooping);
  if (m.isGhost != null) w.bool(96, m.isGhost);
  if (m.copies != null) w.int32(104, m.copies);
  if (m.clientIds != null) for (const e of m.clientIds) w.string(114, e);
  if (m.conflict != null) w.int32(120, m.conflict);
  if (m.livePrefix != null) w.string(130, m.livePrefix);
  if (m.topicCount != null) w.int32(136, m.topicCount);
  if (m.recordCount != null) w.double(145, m.recordCount);
  if (m.mutedCount != null) w.double(153, m.mutedCount);
  if (m.mutedTopics != null) for (const e of m.mutedTopics) w.string(162, e);
  if (m.refusedCount != null) w.double(169, m.refusedCount);
  if (m.problem != null) w.string(178, m.problem);
  if (m.session != null) { const at = w.open(186); encodeReplayedSession(m.session, w); w.close(at); }
  if (m.startedMs != null) w.double(193, m.startedMs);
  if (m.recordingStartedMs != null) w.double(201, m.recordingStartedMs);
}

export function decodeReplay(r: Reader, into?: T.Replay): T.Replay {
  const m: T.Replay = into ?? { id: '', name: '', recordingId: '', recordingName: '', author: '', state: 0, positionMs: 0, durationMs: 0, rate: 0, span: undefined, isLooping: false, isGhost: false, copies: 0, clientIds: [], conflict: 0, livePrefix: '', topicCount: 0, recordCount: 0, mutedCount: 0, mutedTopics: [], refusedCount: 0, problem: '', session: undefined, startedMs: 0, recordingStartedMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.id = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.recordingId = r.string(); break;
      case 34: m.recordingName = r.string(); break;
      case 42: m.author = r.string(); break;
      case 48: m.state = r.int32() as T.ReplayState; break;
      case 57: m.positionMs = r.double(); break;
      case 65: m.durationMs = r.double(); break;
      case 73: m.rate = r.double(); break;
      case 82: { const end = r.enter(); m.span = decodeReplaySpan(r, m.span); r.end = end; break; }
      case 88: m.isLooping = r.bool(); break;
      case 96: m.isGhost = r.bool(); break;
      case 104: m.copies = r.int32(); break;
      case 114: m.clientIds.push(r.string()); break;
      case 120: m.conflict = r.int32() as T.ReplayConflict; break;
      case 130: m.livePrefix = r.string(); break;
      case 136: m.topicCount = r.int32(); break;
      case 145: m.recordCount = r.double(); break;
      case 153: m.mutedCount = r.double(); break;
      case 162: m.mutedTopics.push(r.string()); break;
      case 169: m.refusedCount = r.double(); break;
      case 178: m.problem = r.string(); break;
      case 186: { const end = r.enter(); m.session = decodeReplayedSession(r, m.session); r.end = end; break; }
      case 193: m.startedMs = r.double(); break;
      case 201: m.recordingStartedMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeReplayList(m: Init<T.ReplayList>, w: Writer): void {
  if (m.elements != null) for (const e of m.elements) { const at = w.open(10); encodeReplay(e, w); w.close(at); }
}

export function decodeReplayList(r: Reader, into?: T.ReplayList): T.ReplayList {
  const m: T.ReplayList = into ?? { elements: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.elements.push(decodeReplay(r)); r.end = end; break; }
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeReplaySpan(m: Init<T.ReplaySpan>, w: Writer): void {
  if (m.fromMs != null) w.double(9, m.fromMs);
  if (m.untilMs != null) w.double(17, m.untilMs);
}

export function decodeReplaySpan(r: Reader, into?: T.ReplaySpan): T.ReplaySpan {
  const m: T.ReplaySpan = into ?? { fromMs: 0, untilMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 9: m.fromMs = r.double(); break;
      case 17: m.untilMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeReplayedSession(m: Init<T.ReplayedSession>, w: Writer): void {
  if (m.sessionId != null) w.string(10, m.sessionId);
  if (m.name != null) w.string(18, m.name);
  if (m.runningId != null) w.string(26, m.runningId);
  if (m.comparisonRecordingId != null) w.string(34, m.comparisonRecordingId);
  if (m.inputPrefix != null) w.string(42, m.inputPrefix);
  if (m.outputPrefix != null) w.string(50, m.outputPrefix);
  if (m.recordedModules != null) for (const e of m.recordedModules) w.string(58, e);
}

export function decodeReplayedSession(r: Reader, into?: T.ReplayedSession): T.ReplayedSession {
  const m: T.ReplayedSession = into ?? { sessionId: '', name: '', runningId: '', comparisonRecordingId: '', inputPrefix: '', outputPrefix: '', recordedModules: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.sessionId = r.string(); break;
      case 18: m.name = r.string(); break;
      case 26: m.runningId = r.string(); break;
      case 34: m.comparisonRecordingId = r.string(); break;
      case 42: m.inputPrefix = r.string(); break;
      case 50: m.outputPrefix = r.string(); break;
      case 58: m.recordedModules.push(r.string()); break;
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

export function encodeStudyCheckItem(m: Init<T.StudyCheckItem>, w: Writer): void {
  if (m.kind != null) w.int32(8, m.kind);
  if (m.state != null) w.int32(16, m.state);
  if (m.text != null) w.string(26, m.text);
}

export function decodeStudyCheckItem(r: Reader, into?: T.StudyCheckItem): T.StudyCheckItem {
  const m: T.StudyCheckItem = into ?? { kind: 0, state: 0, text: '' };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 8: m.kind = r.int32() as T.StudyCheckKind; break;
      case 16: m.state = r.int32() as T.StudyCheckState; break;
      case 26: m.text = r.string(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStudyCheckList(m: Init<T.StudyCheckList>, w: Writer): void {
  if (m.studyId != null) w.string(10, m.studyId);
  if (m.timeMs != null) w.double(17, m.timeMs);
  if (m.rows != null) for (const e of m.rows) { const at = w.open(26); encodeStudyCheckRow(e, w); w.close(at); }
  if (m.isReady != null) w.bool(32, m.isReady);
}

export function decodeStudyCheckList(r: Reader, into?: T.StudyCheckList): T.StudyCheckList {
  const m: T.StudyCheckList = into ?? { studyId: '', timeMs: 0, rows: [], isReady: false };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.studyId = r.string(); break;
      case 17: m.timeMs = r.double(); break;
      case 26: { const end = r.enter(); m.rows.push(decodeStudyCheckRow(r)); r.end = end; break; }
      case 32: m.isReady = r.bool(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStudyCheckRow(m: Init<T.StudyCheckRow>, w: Writer): void {
  if (m.name != null) w.string(10, m.name);
  if (m.state != null) w.int32(16, m.state);
  if (m.items != null) for (const e of m.items) { const at = w.open(26); encodeStudyCheckItem(e, w); w.close(at); }
  if (m.found != null) for (const e of m.found) w.string(34, e);
}

export function decodeStudyCheckRow(r: Reader, into?: T.StudyCheckRow): T.StudyCheckRow {
  const m: T.StudyCheckRow = into ?? { name: '', state: 0, items: [], found: [] };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.name = r.string(); break;
      case 16: m.state = r.int32() as T.StudyCheckState; break;
      case 26: { const end = r.enter(); m.items.push(decodeStudyCheckItem(r)); r.end = end; break; }
      case 34: m.found.push(r.string()); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStudyRunNews(m: Init<T.StudyRunNews>, w: Writer): void {
  if (m.runId != null) w.string(10, m.runId);
  if (m.studyId != null) w.string(18, m.studyId);
  if (m.revision != null) w.int32(24, m.revision);
  if (m.block != null) w.int32(32, m.block);
  if (m.recordingId != null) w.string(42, m.recordingId);
  if (m.elapsedMs != null) w.double(49, m.elapsedMs);
  if (m.blockMs != null) w.double(57, m.blockMs);
}

export function decodeStudyRunNews(r: Reader, into?: T.StudyRunNews): T.StudyRunNews {
  const m: T.StudyRunNews = into ?? { runId: '', studyId: '', revision: 0, block: 0, recordingId: '', elapsedMs: 0, blockMs: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: m.runId = r.string(); break;
      case 18: m.studyId = r.string(); break;
      case 24: m.revision = r.int32(); break;
      case 32: m.block = r.int32(); break;
      case 42: m.recordingId = r.string(); break;
      case 49: m.elapsedMs = r.double(); break;
      case 57: m.blockMs = r.double(); break;
      default: skipField(r, tag);
    }
  }
  return m;
}

export function encodeStudyStatus(m: Init<T.StudyStatus>, w: Writer): void {
  if (m.runs != null) for (const e of m.runs) { const at = w.open(10); encodeStudyRunNews(e, w); w.close(at); }
  if (m.checkLists != null) for (const e of m.checkLists) { const at = w.open(18); encodeStudyCheckList(e, w); w.close(at); }
  if (m.listRevision != null) w.int32(24, m.listRevision);
}

export function decodeStudyStatus(r: Reader, into?: T.StudyStatus): T.StudyStatus {
  const m: T.StudyStatus = into ?? { runs: [], checkLists: [], listRevision: 0 };
  while (r.pos < r.end) {
    const tag = r.tag();
    switch (tag) {
      case 10: { const end = r.enter(); m.runs.push(decodeStudyRunNews(r)); r.end = end; break; }
      case 18: { const end = r.enter(); m.checkLists.push(decodeStudyCheckList(r)); r.end = end; break; }
      case 24: m.listRevision = r.int32(); break;
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
  if (m.session != null) { const at = w.open(258); Session.encode(m.session, w); w.close(at); }
  if (m.clientId != null) w.string(266, m.clientId);
  if (m.touchEventList != null) { const at = w.open(274); encodeTouchEventList(m.touchEventList, w); w.close(at); }
  if (m.vector2List != null) { const at = w.open(282); encodeVector2List(m.vector2List, w); w.close(at); }
  if (m.vector3List != null) { const at = w.open(290); encodeVector3List(m.vector3List, w); w.close(at); }
  if (m.vector4List != null) { const at = w.open(298); encodeVector4List(m.vector4List, w); w.close(at); }
  if (m.quaternionList != null) { const at = w.open(306); encodeQuaternion(m.quaternionList, w); w.close(at); }
  if (m.error != null) { const at = w.open(314); encodeErrorMessage(m.error, w); w.close(at); }
  if (m.device != null) { const at = w.open(322); Device.encode(m.device, w); w.close(at); }
  if (m.deviceList != null) { const at = w.open(330); DeviceList.encode(m.deviceList, w); w.close(at); }
  if (m.component != null) { const at = w.open(338); Component.encode(m.component, w); w.close(at); }
  if (m.componentList != null) { const at = w.open(346); ComponentList.encode(m.componentList, w); w.close(at); }
  if (m.sessionList != null) { const at = w.open(354); SessionList.encode(m.sessionList, w); w.close(at); }
  if (m.client != null) { const at = w.open(8002); Client.encode(m.client, w); w.close(at); }
  if (m.sessionStatistics != null) { const at = w.open(8010); SessionStatistics.encode(m.sessionStatistics, w); w.close(at); }
  if (m.moduleEvent != null) { const at = w.open(8018); ModuleEvent.encode(m.moduleEvent, w); w.close(at); }
  if (m.extension != null) { const at = w.open(8026); encodeRecordExtension(m.extension, w); w.close(at); }
  if (m.recordingStatus != null) { const at = w.open(8082); RecordingStatus.encode(m.recordingStatus, w); w.close(at); }
  if (m.replayList != null) { const at = w.open(8090); encodeReplayList(m.replayList, w); w.close(at); }
  if (m.studyStatus != null) { const at = w.open(8682); encodeStudyStatus(m.studyStatus, w); w.close(at); }
}

const TopicDataRecord_type = ['double', 'bool', 'string', 'vector2', 'vector3', 'vector4', 'quaternion', 'matrix3x2', 'matrix4x4', 'color', 'touchEvent', 'keyEvent', 'mouseEvent', 'myoEvent', 'pose2D', 'pose3D', 'object2D', 'object3D', 'object2DList', 'object3DList', 'int32', 'float', 'int32List', 'floatList', 'doubleList', 'stringList', 'boolList', 'image2D', 'image2DList', 'session', 'touchEventList', 'vector2List', 'vector3List', 'vector4List', 'quaternionList', 'error', 'device', 'deviceList', 'component', 'componentList', 'sessionList', 'client', 'sessionStatistics', 'moduleEvent', 'recordingStatus', 'replayList', 'studyStatus'] as const;
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
      case 258: type = only(m, type, 'session'); { const end = r.enter(); m.session = Session.decode(r, m.session); r.end = end; break; }
      case 266: m.clientId = r.string(); break;
      case 274: type = only(m, type, 'touchEventList'); { const end = r.enter(); m.touchEventList = decodeTouchEventList(r, m.touchEventList); r.end = end; break; }
      case 282: type = only(m, type, 'vector2List'); { const end = r.enter(); m.vector2List = decodeVector2List(r, m.vector2List); r.end = end; break; }
      case 290: type = only(m, type, 'vector3List'); { const end = r.enter(); m.vector3List = decodeVector3List(r, m.vector3List); r.end = end; break; }
      case 298: type = only(m, type, 'vector4List'); { const end = r.enter(); m.vector4List = decodeVector4List(r, m.vector4List); r.end = end; break; }
      case 306: type = only(m, type, 'quaternionList'); { const end = r.enter(); m.quaternionList = decodeQuaternion(r, m.quaternionList); r.end = end; break; }
      case 314: type = only(m, type, 'error'); { const end = r.enter(); m.error = decodeErrorMessage(r, m.error); r.end = end; break; }
      case 322: type = only(m, type, 'device'); { const end = r.enter(); m.device = Device.decode(r, m.device); r.end = end; break; }
      case 330: type = only(m, type, 'deviceList'); { const end = r.enter(); m.deviceList = DeviceList.decode(r, m.deviceList); r.end = end; break; }
      case 338: type = only(m, type, 'component'); { const end = r.enter(); m.component = Component.decode(r, m.component); r.end = end; break; }
      case 346: type = only(m, type, 'componentList'); { const end = r.enter(); m.componentList = ComponentList.decode(r, m.componentList); r.end = end; break; }
      case 354: type = only(m, type, 'sessionList'); { const end = r.enter(); m.sessionList = SessionList.decode(r, m.sessionList); r.end = end; break; }
      case 8002: type = only(m, type, 'client'); { const end = r.enter(); m.client = Client.decode(r, m.client); r.end = end; break; }
      case 8010: type = only(m, type, 'sessionStatistics'); { const end = r.enter(); m.sessionStatistics = SessionStatistics.decode(r, m.sessionStatistics); r.end = end; break; }
      case 8018: type = only(m, type, 'moduleEvent'); { const end = r.enter(); m.moduleEvent = ModuleEvent.decode(r, m.moduleEvent); r.end = end; break; }
      case 8026: { const end = r.enter(); m.extension = decodeRecordExtension(r, m.extension); r.end = end; break; }
      case 8082: type = only(m, type, 'recordingStatus'); { const end = r.enter(); m.recordingStatus = RecordingStatus.decode(r, m.recordingStatus); r.end = end; break; }
      case 8090: type = only(m, type, 'replayList'); { const end = r.enter(); m.replayList = decodeReplayList(r, m.replayList); r.end = end; break; }
      case 8682: type = only(m, type, 'studyStatus'); { const end = r.enter(); m.studyStatus = decodeStudyStatus(r, m.studyStatus); r.end = end; break; }
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

/** The generated functions by the full name of their message. */
export const GENERATED_CODECS = {
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
  'ubii.extension.BridgeAnswer': { encode: encodeBridgeAnswer, decode: decodeBridgeAnswer },
  'ubii.extension.BridgeMappingProblem': { encode: encodeBridgeMappingProblem, decode: decodeBridgeMappingProblem },
  'ubii.extension.BridgeMappings': { encode: encodeBridgeMappings, decode: decodeBridgeMappings },
  'ubii.extension.BridgeMappingsChange': { encode: encodeBridgeMappingsChange, decode: decodeBridgeMappingsChange },
  'ubii.extension.BridgeMappingsRequest': { encode: encodeBridgeMappingsRequest, decode: decodeBridgeMappingsRequest },
  'ubii.extension.BridgeMatch': { encode: encodeBridgeMatch, decode: decodeBridgeMatch },
  'ubii.extension.BridgeOrder': { encode: encodeBridgeOrder, decode: decodeBridgeOrder },
  'ubii.extension.ClientClock': { encode: encodeClientClock, decode: decodeClientClock },
  'ubii.extension.EndedTopics': { encode: encodeEndedTopics, decode: decodeEndedTopics },
  'ubii.extension.JoinRefusal': { encode: encodeJoinRefusal, decode: decodeJoinRefusal },
  'ubii.extension.NodeMessage': { encode: encodeNodeMessage, decode: decodeNodeMessage },
  'ubii.extension.NodeRecorderAnswer': { encode: encodeNodeRecorderAnswer, decode: decodeNodeRecorderAnswer },
  'ubii.extension.NodeRecorderClock': { encode: encodeNodeRecorderClock, decode: decodeNodeRecorderClock },
  'ubii.extension.NodeRecorderFacts': { encode: encodeNodeRecorderFacts, decode: decodeNodeRecorderFacts },
  'ubii.extension.NodeRecorderMark': { encode: encodeNodeRecorderMark, decode: decodeNodeRecorderMark },
  'ubii.extension.NodeRecorderOrder': { encode: encodeNodeRecorderOrder, decode: decodeNodeRecorderOrder },
  'ubii.extension.NodeRecorderReport': { encode: encodeNodeRecorderReport, decode: decodeNodeRecorderReport },
  'ubii.extension.NodeRecorderSource': { encode: encodeNodeRecorderSource, decode: decodeNodeRecorderSource },
  'ubii.extension.NodeRecorderSources': { encode: encodeNodeRecorderSources, decode: decodeNodeRecorderSources },
  'ubii.extension.NodeRecorderStart': { encode: encodeNodeRecorderStart, decode: decodeNodeRecorderStart },
  'ubii.extension.RecordExtension': { encode: encodeRecordExtension, decode: decodeRecordExtension },
  'ubii.extension.Recording': { encode: encodeRecording, decode: decodeRecording },
  'ubii.extension.RecordingBudget': { encode: encodeRecordingBudget, decode: decodeRecordingBudget },
  'ubii.extension.RecordingChangeRequest': { encode: encodeRecordingChangeRequest, decode: decodeRecordingChangeRequest },
  'ubii.extension.RecordingMarker': { encode: encodeRecordingMarker, decode: decodeRecordingMarker },
  'ubii.extension.RecordingRequest': { encode: encodeRecordingRequest, decode: decodeRecordingRequest },
  'ubii.extension.RecordingSelection': { encode: encodeRecordingSelection, decode: decodeRecordingSelection },
  'ubii.extension.RecordingStudy': { encode: encodeRecordingStudy, decode: decodeRecordingStudy },
  'ubii.extension.RecordingTopic': { encode: encodeRecordingTopic, decode: decodeRecordingTopic },
  'ubii.extension.Replay': { encode: encodeReplay, decode: decodeReplay },
  'ubii.extension.ReplayList': { encode: encodeReplayList, decode: decodeReplayList },
  'ubii.extension.ReplaySpan': { encode: encodeReplaySpan, decode: decodeReplaySpan },
  'ubii.extension.ReplayedSession': { encode: encodeReplayedSession, decode: decodeReplayedSession },
  'ubii.extension.SessionProblem': { encode: encodeSessionProblem, decode: decodeSessionProblem },
  'ubii.extension.StudyCheckItem': { encode: encodeStudyCheckItem, decode: decodeStudyCheckItem },
  'ubii.extension.StudyCheckList': { encode: encodeStudyCheckList, decode: decodeStudyCheckList },
  'ubii.extension.StudyCheckRow': { encode: encodeStudyCheckRow, decode: decodeStudyCheckRow },
  'ubii.extension.StudyRunNews': { encode: encodeStudyRunNews, decode: decodeStudyRunNews },
  'ubii.extension.StudyStatus': { encode: encodeStudyStatus, decode: decodeStudyStatus },
  'ubii.general.Error': { encode: encodeErrorMessage, decode: decodeErrorMessage },
  'ubii.processing.LockstepProcessingReply': { encode: encodeLockstepProcessingReply, decode: decodeLockstepProcessingReply },
  'ubii.processing.LockstepProcessingRequest': { encode: encodeLockstepProcessingRequest, decode: decodeLockstepProcessingRequest },
  'ubii.topicData.Timestamp': { encode: encodeTimestamp, decode: decodeTimestamp },
  'ubii.topicData.TopicData': { encode: encodeTopicData, decode: decodeTopicData },
  'ubii.topicData.TopicDataRecord': { encode: encodeTopicDataRecord, decode: decodeTopicDataRecord },
  'ubii.topicData.TopicDataRecordList': { encode: encodeTopicDataRecordList, decode: decodeTopicDataRecordList },
} as const satisfies { readonly [K in keyof T.MessageTypes]?: CodecOf<K> };
