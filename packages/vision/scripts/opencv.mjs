import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const { resolve } = createRequire(import.meta.url);

const NOTICE = `/*! OpenCV.js 4.12.0, (c) OpenCV team, Apache-2.0, from @techstark/opencv-js. Changed by Ubi-Interact: the WebAssembly is a file of its own, and the script is a function that finds no process, document or network. Contains zlib, (c) Jean-loup Gailly and Mark Adler; protobuf, (c) Google Inc., BSD-3-Clause; FlatBuffers, (c) Google Inc., Apache-2.0; code of AprilTag, (c) The Regents of The University of Michigan, BSD-2-Clause; Emscripten, (c) its authors, MIT. */`;

/**
 * Names the script looks for to find out where it runs. All are undefined, so that it takes the same way
 * everywhere: on Node it would install handlers of uncaught exceptions that end the process, and in
 * workers it would look for an address.
 */
const HIDDEN = [
  'process',
  'require',
  'module',
  'exports',
  'define',
  'window',
  'self',
  'document',
  'importScripts',
  'fetch',
  'XMLHttpRequest',
  'read',
  'readbuffer',
  'scriptArgs',
  'print',
  'printErr',
  'quit',
];

export const opencvFolder = () => dirname(dirname(resolve('@techstark/opencv-js')));

/**
 * Takes the published OpenCV.js apart: a script whose value is a function of Emscripten's options, which
 * returns the library, and the WebAssembly.
 *
 * @returns {Record<string, Uint8Array>} bytes by filename
 */
export function readOpenCv() {
  const text = readFileSync(join(opencvFolder(), 'dist', 'opencv.js'), 'utf8');
  const wasm = /"data:application\/octet-stream;base64,([A-Za-z0-9+/=]+)"/.exec(text);
  if (wasm === null) throw new Error('@techstark/opencv-js has no WebAssembly inside.');
  let script = text.replace(wasm[0], '"opencv.wasm"');
  script = replaceOnce(script, 'var Module = {};', 'var Module = options;');
  // The wrapper for module systems: what it would hand to them is returned
  script = replaceOnce(script, '}(this, function () {', '})({}, function () {');
  script = replaceOnce(script, '(function (root, factory) {', 'return (function (root, factory) {');
  script = replaceOnce(script, '}));', '});', script.lastIndexOf('}));'));
  script = script.replaceAll('root.cv = factory();', 'return factory();');
  const wrapped = `${NOTICE}\n(function (options) { return (function (${HIDDEN.join(', ')}) {\n${script}\n})(); })`;
  return {
    'opencv.js': new TextEncoder().encode(wrapped),
    'opencv.wasm': new Uint8Array(Buffer.from(wasm[1], 'base64')),
  };
}

/** @param {string} text @param {string} old @param {string} replacement @param {number} [from] */
function replaceOnce(text, old, replacement, from = 0) {
  const at = text.indexOf(old, from);
  if (at < 0 || text.includes(old, at + 1)) {
    throw new Error(`OpenCV.js has not one "${old}": look at it again.`);
  }
  return text.slice(0, at) + replacement + text.slice(at + old.length);
}
