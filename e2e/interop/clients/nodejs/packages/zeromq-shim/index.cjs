/* global module, require */
'use strict';

// The node's own files require('zeromq') and mean version 5. Version 6 has its interface, too.
// eslint-disable-next-line @typescript-eslint/no-require-imports -- the node loads it by require.
module.exports = require('zeromq-6/v5-compat');
