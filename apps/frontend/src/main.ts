import './styles/index.css';
import { createApp } from 'vue';
import { createRouter, createWebHistory } from 'vue-router';
import App from './App.vue';
import { CONNECTION } from './connection/connection.ts';
import { createConnection } from './connection/create-connection.ts';
import { pageStorages, takeHandOver } from './connection/hand-over.ts';
import { keepInstallOffer } from './install/install-offer.ts';
import { sendToJoin } from './joining/join/send-to-join.ts';
import { keepInReach } from './out-of-reach/keep-in-reach.ts';
import { routes } from './routes.ts';
import { createTabNode } from './tab-node/create-tab-node.ts';
import { openTabNode } from './tab-node/open-tab-node.ts';
import { TAB_NODE } from './tab-node/tab-node.ts';
import { createToasts, provideToasts } from './ui/toasts/toasts.ts';

// Before anything reads the address, or who the page is
takeHandOver(location, history, pageStorages());
keepInstallOffer();
const app = createApp(App);
const router = createRouter({ history: createWebHistory(), routes });
const connection = app.runWithContext(() => createConnection());

sendToJoin(connection.client, router);

app.use(router);
app.provide(CONNECTION, connection);
app.provide(
  TAB_NODE,
  app.runWithContext(() => createTabNode(connection.client, openTabNode)),
);
const toasts = createToasts();
provideToasts(app, toasts);
app.mount('#app');
connection.connect();
// After everything that the page itself wants
addEventListener('load', keepInReach);
