/* global module */
'use strict';

// The node's own files require('zeromq') when they are loaded, whatever transport is used. Over HTTP
// and WebSocket no socket is ever made; if one were, the test must fail and say so.
module.exports = {
  socket(type) {
    throw new Error(`the interop test has no ZeroMQ, yet a "${type}" socket was asked for`);
  },
};
