<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR" sourcelanguage="en">
<context>
    <name>dobra</name>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Go to the step and the place</source>
        <translation>Ir à etapa e ao lugar</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fechar esta mensagem</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>não definido</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>nenhum arquivo</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Escolher um arquivo</translation>
    </message>
    <message>
        <source>Pick a name from the model</source>
        <translation>Escolher um nome do modelo</translation>
    </message>
    <message>
        <source>(default)</source>
        <translation>(padrão)</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>escreva true ou false</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of the choices</source>
        <translation>&apos;%1&apos; não é uma das opções</translation>
    </message>
    <message>
        <source>x, y on each line</source>
        <translation>x, y em cada linha</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; is not a number</source>
        <translation>linha %1: &apos;%2&apos; não é um número</translation>
    </message>
    <message>
        <source>line %1: a point has two numbers, x and y</source>
        <translation>linha %1: um ponto tem dois números, x e y</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Cenários</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Etapas</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parâmetros</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Camadas</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Add &apos;%1&apos;</source>
        <translation>Acrescentar &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Remove step %1</source>
        <translation>Remover a etapa %1</translation>
    </message>
    <message>
        <source>Exchange steps %1 and %2</source>
        <translation>Trocar as etapas %1 e %2</translation>
    </message>
    <message>
        <source>Change &apos;%1&apos;</source>
        <translation>Mudar &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arquivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>E&amp;xibir</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;xecutar</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aj&amp;uda</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salvar</translation>
    </message>
    <message>
        <source>Save &amp;As...</source>
        <translation>Salvar &amp;como...</translation>
    </message>
    <message>
        <source>Save &amp;Picture...</source>
        <translation>Salvar &amp;figura...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sai&amp;r</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Desfazer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refazer</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Enquadrar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;About %1</source>
        <translation>&amp;Sobre o %1</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Ferramentas</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 foi salvo</translation>
    </message>
    <message>
        <source>there is no picture yet; run the scenario first</source>
        <translation>ainda não há figura; execute antes o cenário</translation>
    </message>
    <message>
        <source>the view came out blank</source>
        <translation>a vista saiu em branco</translation>
    </message>
    <message>
        <source>cannot write the picture</source>
        <translation>não é possível gravar a figura</translation>
    </message>
    <message>
        <source>Open a scenario</source>
        <translation>Abrir um cenário</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>Salvar o cenário</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 já existe. Substituir?</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Salvar a figura</translation>
    </message>
    <message>
        <source>The scenario has changes that are not saved.</source>
        <translation>O cenário tem mudanças que não foram salvas.</translation>
    </message>
    <message>
        <source>Save them?</source>
        <translation>Salvá-las?</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Restores deformed geological sections.</source>
        <translation>Restaura seções geológicas deformadas.</translation>
    </message>
    <message>
        <source>Prepares finite-element meshes of fractured plane solids and of surfaces and shells in space, and analyses the plane ones.</source>
        <translation>Prepara malhas de elementos finitos de sólidos planos fraturados e de superfícies e cascas no espaço, e analisa as planas.</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Sobre o %1</translation>
    </message>
    <message>
        <source>Part of Dobra. Apache License 2.0.</source>
        <translation>Parte do Dobra. Licença Apache 2.0.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sem título</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>%1 has no such operation.</source>
        <translation>O %1 não tem essa operação.</translation>
    </message>
    <message>
        <source>running</source>
        <translation>executando</translation>
    </message>
    <message>
        <source>Done in %1 s</source>
        <translation>Feito em %1 s</translation>
    </message>
    <message>
        <source>Interrupted. What is shown is the last step that was done.</source>
        <translation>Interrompido. O que se vê é a última etapa que foi feita.</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>maior que %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>no mínimo %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>no máximo %1</translation>
    </message>
    <message>
        <source>required</source>
        <translation>obrigatório</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>padrão %1</translation>
    </message>
    <message>
        <source>Nothing to set.</source>
        <translation>Nada a definir.</translation>
    </message>
    <message>
        <source>Return to the default</source>
        <translation>Voltar ao padrão</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a parameter here</source>
        <translation>&apos;%1&apos; não é um parâmetro aqui</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>no parameter &apos;%1&apos; here</source>
        <translation>não há parâmetro &apos;%1&apos; aqui</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 tables; write %1.NUMBER.KEY</source>
        <translation>&apos;%1&apos; tem %2 tabelas; escreva %1.NÚMERO.CHAVE</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>No remarks.</source>
        <translation>Sem observações.</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>não há nada a desfazer</translation>
    </message>
    <message>
        <source>there is nothing to do again</source>
        <translation>não há nada a refazer</translation>
    </message>
    <message>
        <source>the document has no file yet; write save PATH</source>
        <translation>o documento ainda não tem arquivo; escreva save CAMINHO</translation>
    </message>
    <message>
        <source>no layer &apos;%1&apos;</source>
        <translation>não há camada &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no operation &apos;%1&apos;</source>
        <translation>não há operação &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the input cannot be removed; select a step</source>
        <translation>a entrada não pode ser removida; escolha uma etapa</translation>
    </message>
    <message>
        <source>the error bar says &apos;%1&apos;</source>
        <translation>a barra de erro diz &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no step &apos;%1&apos;; there are %2</source>
        <translation>não há etapa &apos;%1&apos;; elas são %2</translation>
    </message>
    <message>
        <source>write zoom FACTOR X Y with a factor above 0 and X, Y in 0..1</source>
        <translation>escreva zoom FATOR X Y com um fator acima de 0 e X, Y em 0..1</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>não executada</translation>
    </message>
    <message>
        <source>done</source>
        <translation>feita</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>falhou</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>Remover a etapa</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>Mover a etapa para cima</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>Mover a etapa para baixo</translation>
    </message>
    <message>
        <source>Add a step behind the selected one</source>
        <translation>Acrescentar uma etapa depois da escolhida</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Acrescentar</translation>
    </message>
    <message>
        <source>Nothing here.</source>
        <translation>Nada aqui.</translation>
    </message>
    <message>
        <source>%1, item %2</source>
        <translation>%1, item %2</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Deformed section</source>
        <translation>Seção deformada</translation>
    </message>
    <message>
        <source>Domain</source>
        <translation>Domínio</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malha</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nós</translation>
    </message>
    <message>
        <source>Offset constraints</source>
        <translation>Restrições paralelas</translation>
    </message>
    <message>
        <source>Offset curves</source>
        <translation>Curvas paralelas</translation>
    </message>
    <message>
        <source>Pin line</source>
        <translation>Linha de pino</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pino</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>pino</translation>
    </message>
    <message>
        <source>Restored section</source>
        <translation>Seção restaurada</translation>
    </message>
    <message>
        <source>Rungs</source>
        <translation>Transversais</translation>
    </message>
    <message>
        <source>Target grid</source>
        <translation>Malha do alvo</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Alvo</translation>
    </message>
    <message>
        <source>Source grid</source>
        <translation>Malha de origem</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Offset curves of the top of the section and the transversals between them.</source>
        <translation>Curvas paralelas ao topo da seção e as transversais entre elas.</translation>
    </message>
    <message>
        <source>The geometry to which the top is restored, a datum or a line, held at a pin.</source>
        <translation>A geometria para a qual o topo é restaurado, um datum ou uma linha, presa em um pino.</translation>
    </message>
    <message>
        <source>Carries every point of the section from the source grid to the target grid.</source>
        <translation>Leva cada ponto da seção da malha de origem para a malha do alvo.</translation>
    </message>
    <message>
        <source>Offset curves of a boundary, as internal constraints that grade the mesh.</source>
        <translation>Curvas paralelas a um contorno, como restrições internas que graduam a malha.</translation>
    </message>
    <message>
        <source>Divides borders and fills the domain with triangles, or each surface: sizes first, then shapes.</source>
        <translation>Divide os contornos e preenche com triângulos o domínio, ou cada superfície: primeiro os tamanhos, depois as formas.</translation>
    </message>
    <message>
        <source>mean alpha</source>
        <translation>alfa médio</translation>
    </message>
    <message>
        <source>Size by formula</source>
        <translation>Tamanho por fórmula</translation>
    </message>
    <message>
        <source>Background mesh</source>
        <translation>Malha de fundo</translation>
    </message>
    <message>
        <source>Background field</source>
        <translation>Campo da malha de fundo</translation>
    </message>
    <message>
        <source>Division of curves</source>
        <translation>Divisão das curvas</translation>
    </message>
    <message>
        <source>Size field</source>
        <translation>Campo de tamanhos</translation>
    </message>
    <message>
        <source>Quadtree of the sizes</source>
        <translation>Quadtree dos tamanhos</translation>
    </message>
    <message>
        <source>size [m]</source>
        <translation>tamanho [m]</translation>
    </message>
    <message>
        <source>sizes wanted</source>
        <translation>tamanhos desejados</translation>
    </message>
    <message>
        <source>least scaled Jacobian</source>
        <translation>menor jacobiano escalado</translation>
    </message>
    <message>
        <source>quality (alpha, shape of quadrilaterals)</source>
        <translation>qualidade (alfa, forma dos quadriláteros)</translation>
    </message>
    <message>
        <source>quality alpha</source>
        <translation>qualidade alfa</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triângulos</translation>
    </message>
    <message>
        <source>vertical exaggeration</source>
        <translation>exagero vertical</translation>
    </message>
    <message>
        <source>Balance tolerance</source>
        <translation>Tolerância do balanço</translation>
    </message>
    <message>
        <source>Base curves</source>
        <translation>Curvas de base</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Columns of x and y</source>
        <translation>Colunas de x e y</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Cantos</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Direction of the line</source>
        <translation>Sentido da linha</translation>
    </message>
    <message>
        <source>Elevation of the datum</source>
        <translation>Elevação do datum</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Extensão</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Fator</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Feição</translation>
    </message>
    <message>
        <source>File of the line</source>
        <translation>Arquivo da linha</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Arquivo</translation>
    </message>
    <message>
        <source>First distance</source>
        <translation>Primeira distância</translation>
    </message>
    <message>
        <source>Target size</source>
        <translation>Tamanho desejado</translation>
    </message>
    <message>
        <source>Stop after</source>
        <translation>Parar depois de</translation>
    </message>
    <message>
        <source>Steps of the engine, one side of its front or one node each: shows it at work. 0: it goes on until the mesh is done.</source>
        <translation>Passos do gerador, um lado da sua frente ou um nó cada: mostra-o trabalhando. 0: continua até a malha estar pronta.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>passos</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Assistir</translation>
    </message>
    <message>
        <source>Watch it work</source>
        <translation>Assistir ao trabalho</translation>
    </message>
    <message>
        <source>One step more</source>
        <translation>Mais um passo</translation>
    </message>
    <message>
        <source>Stop watching</source>
        <translation>Parar de assistir</translation>
    </message>
    <message>
        <source>At work: after %1 steps</source>
        <translation>Trabalhando: depois de %1 passos</translation>
    </message>
    <message>
        <source>no step of this document can be watched</source>
        <translation>nenhum passo deste documento pode ser assistido</translation>
    </message>
    <message>
        <source>write watch play, pause, stop or step COUNT</source>
        <translation>escreva watch play, pause, stop ou step COUNT</translation>
    </message>
    <message>
        <source>Greatest turn</source>
        <translation>Maior giro</translation>
    </message>
    <message>
        <source>Across narrow places</source>
        <translation>Nos trechos estreitos</translation>
    </message>
    <message>
        <source>Elements wanted across the material where curves, crack tips or points come near each other: sides there are divided as finely. 0: sides are as long as elsewhere.</source>
        <translation>Elementos desejados através do material onde curvas, pontas de trincas ou pontos se aproximam: ali os lados são divididos com essa finura. 0: os lados são tão longos quanto no resto.</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescimento</translation>
    </message>
    <message>
        <source>Horizons</source>
        <translation>Horizontes</translation>
    </message>
    <message>
        <source>Join tolerance</source>
        <translation>Tolerância de junção</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Rótulo</translation>
    </message>
    <message>
        <source>Lines that cross themselves</source>
        <translation>Linhas que cruzam a si mesmas</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Most elements</source>
        <translation>Máximo de elementos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Node spacing</source>
        <translation>Espaçamento dos nós</translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation>Número de curvas</translation>
    </message>
    <message>
        <source>Obey constraints</source>
        <translation>Obedecer às restrições</translation>
    </message>
    <message>
        <source>Pin on the target</source>
        <translation>Pino no alvo</translation>
    </message>
    <message>
        <source>Points of the line</source>
        <translation>Pontos da linha</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Raio</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Razão</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Separador</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Carried lines</source>
        <translation>Linhas transportadas</translation>
    </message>
    <message>
        <source>Carried points</source>
        <translation>Pontos transportados</translation>
    </message>
    <message>
        <source>Section after restoration</source>
        <translation>Seção após a restauração</translation>
    </message>
    <message>
        <source>In any format of lines, like a horizon&apos;s.</source>
        <translation>Em qualquer formato de linhas, como o de um horizonte.</translation>
    </message>
    <message>
        <source>Instead of a file: one point, a line, or a polygon whose last point repeats the first.</source>
        <translation>Em vez de um arquivo: um ponto, uma linha ou um polígono cujo último ponto repete o primeiro.</translation>
    </message>
    <message>
        <source>Points, lines or polygons of one state of the section, carried to another, forward or back.</source>
        <translation>Pontos, linhas ou polígonos de um estado da seção, transportados para outro, para a frente ou para trás.</translation>
    </message>
    <message>
        <source>Stands on</source>
        <translation>Apoia-se em</translation>
    </message>
    <message>
        <source>To state</source>
        <translation>Para o estado</translation>
    </message>
    <message>
        <source>From state</source>
        <translation>Do estado</translation>
    </message>
    <message>
        <source>Carry</source>
        <translation>Transportar</translation>
    </message>
    <message>
        <source>By default the last.</source>
        <translation>Por padrão, o último.</translation>
    </message>
    <message>
        <source>current: the section as the steps before leave it; input: as it was read, which begins anew.</source>
        <translation>current: a seção como os passos anteriores a deixam; input: como foi lida, o que recomeça.</translation>
    </message>
    <message>
        <source>Taken as</source>
        <translation>Tomados como</translation>
    </message>
    <message>
        <source>line: joined in their order; points: each by itself.</source>
        <translation>line: ligados na sua ordem; points: cada um por si.</translation>
    </message>
    <message>
        <source>Simplify the top</source>
        <translation>Simplificar o topo</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Smoothing passes</source>
        <translation>Passadas de suavização</translation>
    </message>
    <message>
        <source>Spurious regions</source>
        <translation>Regiões espúrias</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Ângulo inicial</translation>
    </message>
    <message>
        <source>Sweep angle</source>
        <translation>Ângulo varrido</translation>
    </message>
    <message>
        <source>Top horizon</source>
        <translation>Horizonte do topo</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>x of the pin</source>
        <translation>x do pino</translation>
    </message>
    <message>
        <source>A .poly file of Triangle with the boundary, in place of curves or beside them.</source>
        <translation>Um arquivo .poly do Triangle com o contorno, no lugar das curvas ou ao lado delas.</translation>
    </message>
    <message>
        <source>By default such that the curves reach the deepest point.</source>
        <translation>Por padrão, tal que as curvas alcancem o ponto mais profundo.</translation>
    </message>
    <message>
        <source>By default that of the top at the pin.</source>
        <translation>Por padrão, a do topo no pino.</translation>
    </message>
    <message>
        <source>D_k = factor D_(k-1) + first distance; 1 spaces the curves equally.</source>
        <translation>D_k = fator D_(k-1) + primeira distância; com 1 as curvas ficam igualmente espaçadas.</translation>
    </message>
    <message>
        <source>Each gap is this many times the one before.</source>
        <translation>Cada intervalo é este número de vezes o anterior.</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fechadas</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colunas</translation>
    </message>
    <message>
        <source>Columns of names</source>
        <translation>Colunas de nomes</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordenadas</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Traço</translation>
    </message>
    <message>
        <source>Plane tolerance</source>
        <translation>Tolerância do plano</translation>
    </message>
    <message>
        <source>Heights grow</source>
        <translation>Alturas crescem</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referência</translation>
    </message>
    <message>
        <source>Exaggeration</source>
        <translation>Exagero</translation>
    </message>
    <message>
        <source>yes: every line of the file is an outline, whose last point need not repeat the first.</source>
        <translation>yes: cada linha do arquivo é um contorno, cujo último ponto não precisa repetir o primeiro.</translation>
    </message>
    <message>
        <source>Of a file of lines; by its ending otherwise.</source>
        <translation>De um arquivo de linhas; senão, pela terminação do nome.</translation>
    </message>
    <message>
        <source>section: x and y as they stand; map: lines on a vertical plane in space.</source>
        <translation>section: x e y como estão; map: linhas sobre um plano vertical no espaço.</translation>
    </message>
    <message>
        <source>Trend and plunge of the axis along which lines in space are projected.</source>
        <translation>Direção e caimento do eixo ao longo do qual linhas no espaço são projetadas.</translation>
    </message>
    <message>
        <source>Largest distance of lines in space from their plane, as a part of the length.</source>
        <translation>Maior distância de linhas no espaço ao seu plano, como parte do comprimento.</translation>
    </message>
    <message>
        <source>With y_axis = &quot;down&quot;: the value at height 0, in units of the file.</source>
        <translation>Com y_axis = &quot;down&quot;: o valor na altura 0, nas unidades do arquivo.</translation>
    </message>
    <message>
        <source>Heights are stored this many times too large.</source>
        <translation>As alturas estão guardadas este número de vezes maiores.</translation>
    </message>
    <message>
        <source>Ends of curves nearer than this fraction of the domain&apos;s diagonal are one point.</source>
        <translation>Pontas de curvas mais próximas que esta fração da diagonal do domínio são um só ponto.</translation>
    </message>
    <message>
        <source>From the base to the first curve.</source>
        <translation>Da base à primeira curva.</translation>
    </message>
    <message>
        <source>Greatest change of a bed&apos;s length in a balanced section.</source>
        <translation>Maior mudança do comprimento de uma camada em uma seção balanceada.</translation>
    </message>
    <message>
        <source>In a text file, counted from 1.</source>
        <translation>Em um arquivo de texto, contadas a partir de 1.</translation>
    </message>
    <message>
        <source>Last side to first side, for `segments`.</source>
        <translation>Do último lado ao primeiro, para `segments`.</translation>
    </message>
    <message>
        <source>Length of the element sides along the curve; 0 leaves it to the mesh step.</source>
        <translation>Comprimento dos lados dos elementos ao longo da curva; 0 deixa-o para a etapa da malha.</translation>
    </message>
    <message>
        <source>Most by which sizes may grow from one element to the next.</source>
        <translation>O máximo que os tamanhos podem crescer de um elemento para o vizinho.</translation>
    </message>
    <message>
        <source>Multiplies the distance of the nodes (ring).</source>
        <translation>Multiplica a distância dos nós (ring).</translation>
    </message>
    <message>
        <source>Name of the feature in a GeoJSON file that holds several lines.</source>
        <translation>Nome da feição em um arquivo GeoJSON com várias linhas.</translation>
    </message>
    <message>
        <source>Names of one curve, or of curves that follow each other.</source>
        <translation>Nomes de uma curva, ou de curvas que se seguem.</translation>
    </message>
    <message>
        <source>Number of element sides along the curve; 0 leaves it to the sizes.</source>
        <translation>Número de lados de elementos ao longo da curva; 0 deixa-o para os tamanhos.</translation>
    </message>
    <message>
        <source>Of a circle, or of an arc given by angles.</source>
        <translation>De um círculo, ou de um arco dado por ângulos.</translation>
    </message>
    <message>
        <source>Of an arc given by its two points.</source>
        <translation>De um arco dado por seus dois pontos.</translation>
    </message>
    <message>
        <source>Of an arc or circle.</source>
        <translation>De um arco ou círculo.</translation>
    </message>
    <message>
        <source>Of an arc, anticlockwise from +x.</source>
        <translation>De um arco, no sentido anti-horário a partir de +x.</translation>
    </message>
    <message>
        <source>Of an arc; negative runs clockwise.</source>
        <translation>De um arco; negativo vai no sentido horário.</translation>
    </message>
    <message>
        <source>Sets of the mesh take it.</source>
        <translation>Os conjuntos da malha o tomam.</translation>
    </message>
    <message>
        <source>Stands above the picture of this mesh.</source>
        <translation>Fica acima da figura desta malha.</translation>
    </message>
    <message>
        <source>That one element side on an arc may span.</source>
        <translation>Que um lado de elemento em um arco pode abranger.</translation>
    </message>
    <message>
        <source>The boundary, in any order and direction; internal lines.</source>
        <translation>O contorno, em qualquer ordem e sentido; linhas internas.</translation>
    </message>
    <message>
        <source>The horizon that the curves are parallel to; by default the first.</source>
        <translation>O horizonte ao qual as curvas são paralelas; por padrão o primeiro.</translation>
    </message>
    <message>
        <source>The line itself, [[x, y], ...]; instead of a file.</source>
        <translation>A própria linha, [[x, y], ...]; em vez de um arquivo.</translation>
    </message>
    <message>
        <source>The mesher stops with advice beyond it.</source>
        <translation>Além dele o gerador para com um conselho.</translation>
    </message>
    <message>
        <source>The point to which the pin goes; by default the one with the same x.</source>
        <translation>O ponto para onde vai o pino; por padrão o de mesmo x.</translation>
    </message>
    <message>
        <source>Vertices of a line or polygon; first and last point of an arc.</source>
        <translation>Vértices de uma linha ou polígono; primeiro e último ponto de um arco.</translation>
    </message>
    <message>
        <source>Role in the balance</source>
        <translation>Papel no balanço</translation>
    </message>
    <message>
        <source>growth: a horizon laid down while the section deformed; it is listed, not judged.</source>
        <translation>growth: um horizonte depositado durante a deformação da seção; é listado, não julgado.</translation>
    </message>
    <message>
        <source>Where the top is held; by default the leftmost place where all horizons are.</source>
        <translation>Onde o topo é preso; por padrão o lugar mais à esquerda em que estão todos os horizontes.</translation>
    </message>
    <message>
        <source>as_given: its first point goes with the left end of the top.</source>
        <translation>as_given: seu primeiro ponto vai com a ponta esquerda do topo.</translation>
    </message>
    <message>
        <source>auto: the side of the other horizons, below if there are none.</source>
        <translation>auto: o lado dos outros horizontes, abaixo se não houver.</translation>
    </message>
    <message>
        <source>constant: keeps the length of the top and the depth of every point below it.</source>
        <translation>constant: mantém o comprimento do topo e a profundidade de cada ponto abaixo dele.</translation>
    </message>
    <message>
        <source>count: so many curves; base: as many as reach the deepest point of the section.</source>
        <translation>count: tantas curvas; base: tantas quantas alcancem o ponto mais profundo da seção.</translation>
    </message>
    <message>
        <source>cut_loops: small loops of the pen are cut out, with a remark.</source>
        <translation>cut_loops: pequenos laços da pena são cortados, com uma observação.</translation>
    </message>
    <message>
        <source>flat: a horizontal datum; line: the points or the file.</source>
        <translation>flat: um datum horizontal; line: os pontos ou o arquivo.</translation>
    </message>
    <message>
        <source>inside: where the domain is; left or right of the base&apos;s direction.</source>
        <translation>inside: onde está o domínio; left ou right do sentido da base.</translation>
    </message>
    <message>
        <source>line: a chain of points; polygon: closed; arc: centre and two points, or centre, radius, start, sweep; circle: centre and radius.</source>
        <translation>line: uma cadeia de pontos; polygon: fechado; arc: centro e dois pontos, ou centro, raio, início e varrido; circle: centro e raio.</translation>
    </message>
    <message>
        <source>mitre: bisector points up to four distances; bisector: however far, as the rungs go.</source>
        <translation>mitre: pontos na bissetriz até quatro distâncias; bisector: por mais longe que vão as transversais.</translation>
    </message>
    <message>
        <source>ring: as far apart as the curves are; base: as the divided base has them.</source>
        <translation>ring: tão afastados quanto as curvas; base: como na base dividida.</translation>
    </message>
    <message>
        <source>treated: loops of the offset curves are removed.</source>
        <translation>treated: os laços das curvas paralelas são removidos.</translation>
    </message>
    <message>
        <source>Loops inside loops are holes by themselves; role = &quot;hole&quot; insists on it.</source>
        <translation>Laços dentro de laços são furos por si; role = &quot;hole&quot; insiste nisso.</translation>
    </message>
    <message>
        <source>no run has ended yet; write wait before</source>
        <translation>nenhuma execução terminou ainda; escreva wait antes</translation>
    </message>
    <message>
        <source>Open a scenario (Ctrl+O), or drop one here.</source>
        <translation>Abra um cenário (Ctrl+O), ou solte um aqui.</translation>
    </message>
    <message>
        <source>there is no error to go to</source>
        <translation>não há erro aonde ir</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Trincas</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>Linhas internas</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementos</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>elementos</translation>
    </message>
    <message>
        <source>Specimen</source>
        <translation>Corpo de prova</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regiões</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparo</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordem</translation>
    </message>
    <message>
        <source>Quadrilaterals</source>
        <translation>Quadriláteros</translation>
    </message>
    <message>
        <source>Size at the ends</source>
        <translation>Tamanho nas extremidades</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Crack length</source>
        <translation>Comprimento da trinca</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posição</translation>
    </message>
    <message>
        <source>Crack angle</source>
        <translation>Ângulo da trinca</translation>
    </message>
    <message>
        <source>Zone of small elements</source>
        <translation>Zona de elementos pequenos</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Ponto</translation>
    </message>
    <message>
        <source>Elements of a given size within a given distance of curves, cracks or points.</source>
        <translation>Elementos de um tamanho dado a até uma distância dada de curvas, trincas ou pontos.</translation>
    </message>
    <message>
        <source>Of the library, with the six sizes below; see docs/user/specimens.md.</source>
        <translation>Da biblioteca, com as seis medidas abaixo; veja docs/user/specimens.md.</translation>
    </message>
    <message>
        <source>Of the specimen.</source>
        <translation>Do corpo de prova.</translation>
    </message>
    <message>
        <source>Of its hole or disc.</source>
        <translation>Do seu furo ou disco.</translation>
    </message>
    <message>
        <source>As its handbook formula has it: a whole edge crack, half a centre crack.</source>
        <translation>Como na fórmula do manual: a trinca de borda inteira, metade da trinca central.</translation>
    </message>
    <message>
        <source>Of the notch of pmma_beam, from the middle.</source>
        <translation>Do entalhe de pmma_beam, a partir do meio.</translation>
    </message>
    <message>
        <source>Of a centre crack, anticlockwise from +x.</source>
        <translation>De uma trinca central, no sentido anti-horário a partir de +x.</translation>
    </message>
    <message>
        <source>Geometry as a drawing or as lines, or a mesh whose boundary is meant.</source>
        <translation>Geometria como desenho ou como linhas, ou uma malha cujo contorno se quer.</translation>
    </message>
    <message>
        <source>Mends repeated points, spikes, doubles, gaps, slivers and crossings of boundaries, and lists each with its place.</source>
        <translation>Conserta pontos repetidos, espinhos, duplicatas, vãos, lascas e cruzamentos de contornos, e lista cada um com o seu lugar.</translation>
    </message>
    <message>
        <source>Widest gap</source>
        <translation>Maior vão</translation>
    </message>
    <message>
        <source>That repair closes between ends of curves; 1/1000 of the drawing's diagonal by default, 1/10 at most.</source>
        <translation>Que o conserto fecha entre pontas de curvas; por omissão 1/1000 da diagonal do desenho, no máximo 1/10.</translation>
    </message>
    <message>
        <source>Their two lips come apart; they may branch, cross and reach the boundary.</source>
        <translation>As suas duas faces se separam; podem ramificar-se, cruzar-se e chegar ao contorno.</translation>
    </message>
    <message>
        <source>Names of the parts that loops and internal lines enclose.</source>
        <translation>Nomes das partes que os contornos e as linhas internas encerram.</translation>
    </message>
    <message>
        <source>Nodes with a name: supports, loads, gauges.</source>
        <translation>Nós com nome: apoios, cargas, sensores.</translation>
    </message>
    <message>
        <source>The lips are the sets NAME_left and NAME_right, the tips NAME_start and NAME_end.</source>
        <translation>As faces são os conjuntos NOME_left e NOME_right, as pontas NOME_start e NOME_end.</translation>
    </message>
    <message>
        <source>In order from start to end; an end on the boundary or on another crack opens there.</source>
        <translation>Em ordem, do início ao fim; uma extremidade no contorno ou em outra trinca abre-se ali.</translation>
    </message>
    <message>
        <source>Length of the element sides at both ends, from which they grow; 0: none of their own.</source>
        <translation>Comprimento dos lados dos elementos nas duas extremidades, de onde crescem; 0: nenhum próprio.</translation>
    </message>
    <message>
        <source>Of the material; parts of one name are one region.</source>
        <translation>Do material; partes de mesmo nome são uma só região.</translation>
    </message>
    <message>
        <source>Anywhere in the part that is meant.</source>
        <translation>Em qualquer lugar da parte que se quer.</translation>
    </message>
    <message>
        <source>Inside or on a curve: there is a node.</source>
        <translation>Dentro ou sobre uma curva: ali há um nó.</translation>
    </message>
    <message>
        <source>Of the set that holds its node.</source>
        <translation>Do conjunto que contém o seu nó.</translation>
    </message>
    <message>
        <source>2: nodes at mid-sides too, on the true curve.</source>
        <translation>2: nós também no meio dos lados, sobre a curva verdadeira.</translation>
    </message>
    <message>
        <source>Joins pairs of triangles where that gives a good shape.</source>
        <translation>Junta pares de triângulos onde isso dá boa forma.</translation>
    </message>
    <message>
        <source>Names of curves and cracks round which the elements are to be small.</source>
        <translation>Nomes de curvas e trincas em torno das quais os elementos devem ser pequenos.</translation>
    </message>
    <message>
        <source>A line of one's own, or a single point.</source>
        <translation>Uma linha própria, ou um só ponto.</translation>
    </message>
    <message>
        <source>Of the element sides in the zone.</source>
        <translation>Dos lados dos elementos na zona.</translation>
    </message>
    <message>
        <source>How far the zone reaches to either side.</source>
        <translation>Até onde a zona vai, para cada lado.</translation>
    </message>
    <message>
        <source>Rosettes</source>
        <translation>Rosetas</translation>
    </message>
    <message>
        <source>Quarter-point elements round each crack tip; needs order 2. A loop makes them smaller if they hold too much of the error.</source>
        <translation>Elementos de quarto de ponto em volta de cada ponta de trinca; pede ordem 2. Um laço adaptativo os diminui se retêm erro demais.</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Setores</translation>
    </message>
    <message>
        <source>Of a rosette, even.</source>
        <translation>De uma roseta, número par.</translation>
    </message>
    <message>
        <source>Tip elements</source>
        <translation>Elementos da ponta</translation>
    </message>
    <message>
        <source>Length of the quarter-point elements, of the first mesh in a loop; 0 takes 1/80 of the room round the tip: straight end of the crack, ligament, other tips, named points.</source>
        <translation>Comprimento dos elementos de quarto de ponto, da primeira malha num laço adaptativo; 0 toma 1/80 do espaço em volta da ponta: fim reto da trinca, ligamento, outras pontas, pontos com nome.</translation>
    </message>
    <message>
        <source>QUEBRA</source>
        <translation>QUEBRA</translation>
    </message>
    <message>
        <source>Materials, supports, loads</source>
        <translation>Materiais, apoios, cargas</translation>
    </message>
    <message>
        <source>Half of a crack</source>
        <translation>Metade de uma trinca</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Analisar</translation>
    </message>
    <message>
        <source>Adapt</source>
        <translation>Adaptar</translation>
    </message>
    <message>
        <source>Stress intensity factors</source>
        <translation>Fatores de intensidade de tensão</translation>
    </message>
    <message>
        <source>Results along a line</source>
        <translation>Resultados ao longo de uma linha</translation>
    </message>
    <message>
        <source>Results at a point</source>
        <translation>Resultados em um ponto</translation>
    </message>
    <message>
        <source>Picture of a field</source>
        <translation>Figura de um campo</translation>
    </message>
    <message>
        <source>The elastic problem, by the names of regions, curves and points.</source>
        <translation>O problema elástico, pelos nomes de regiões, curvas e pontos.</translation>
    </message>
    <message>
        <source>A curve of the boundary is one lip of a crack on a line of symmetry.</source>
        <translation>Uma curva do contorno é um lábio de uma trinca sobre uma linha de simetria.</translation>
    </message>
    <message>
        <source>Displacements, stresses and their error on the last mesh.</source>
        <translation>Deslocamentos, tensões e seu erro na última malha.</translation>
    </message>
    <message>
        <source>Meshes and analyses until the error asked for is met.</source>
        <translation>Gera malhas e analisa até atingir o erro pedido.</translation>
    </message>
    <message>
        <source>K_I and K_II by three methods, J, T and kink angles at every crack tip.</source>
        <translation>K_I e K_II por três métodos, J, T e ângulos de desvio em cada ponta de trinca.</translation>
    </message>
    <message>
        <source>Displacements and stresses along a line, as a table.</source>
        <translation>Deslocamentos e tensões ao longo de uma linha, em tabela.</translation>
    </message>
    <message>
        <source>Displacements and stresses at a point.</source>
        <translation>Deslocamentos e tensões em um ponto.</translation>
    </message>
    <message>
        <source>A field on the deformed shape: colours, contours, mesh, extremes.</source>
        <translation>Um campo na forma deformada: cores, isolinhas, malha, extremos.</translation>
    </message>
    <message>
        <source>Error asked for</source>
        <translation>Erro pedido</translation>
    </message>
    <message>
        <source>In the energy norm.</source>
        <translation>Na norma da energia.</translation>
    </message>
    <message>
        <source>Mind peaks</source>
        <translation>Cuidar dos picos</translation>
    </message>
    <message>
        <source>Asks for the same error in the elements round each peak of stress: the whole may meet it with a peak that does not.</source>
        <translation>Pede o mesmo erro nos elementos em volta de cada pico de tensão: o todo pode atendê-lo com um pico que não o atende.</translation>
    </message>
    <message>
        <source>Forces at points</source>
        <translation>Forças em pontos</translation>
    </message>
    <message>
        <source>Radius round points</source>
        <translation>Raio em torno dos pontos</translation>
    </message>
    <message>
        <source>Exact energy</source>
        <translation>Energia exata</translation>
    </message>
    <message>
        <source>Strain energy where it is known, one a load case in their order, 0 where it is not: the true error and the effectivity of the estimate are told. Only with supports that stand still.</source>
        <translation>Energia de deformação onde é conhecida, uma por caso de carga, na ordem deles, 0 onde não é: informa o erro verdadeiro e a efetividade da estimativa. Só com apoios que não se movem.</translation>
    </message>
    <message>
        <source>Of those surroundings; 0 takes 1/20 of the room round each: thickness of the material, other boundaries, cracks.</source>
        <translation>Desse entorno; 0 toma 1/20 do espaço em torno de cada um: espessura do material, outros contornos, trincas.</translation>
    </message>
    <message>
        <source>leave_out: the surroundings of points with a force or reaction of their own, where the energy is infinite, do not count for the error; count: they do, and no mesh meets a small error.</source>
        <translation>leave_out: o entorno de pontos com força ou reação própria, onde a energia é infinita, não conta para o erro; count: conta, e nenhuma malha atinge um erro pequeno.</translation>
    </message>
    <message>
        <source>Range of colours</source>
        <translation>Faixa de cores</translation>
    </message>
    <message>
        <source>field: what 99.5 % of the area has, if a peak (a crack tip) stands out of it; full: from the least to the greatest value.</source>
        <translation>field: o que 99,5 % da área tem, se um pico (uma ponta de trinca) se destaca; full: do menor ao maior valor.</translation>
    </message>
    <message>
        <source>Error of each cycle</source>
        <translation>Erro de cada ciclo</translation>
    </message>
    <message>
        <source>best rate</source>
        <translation>melhor taxa</translation>
    </message>
    <message>
        <source>estimated error</source>
        <translation>erro estimado</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>incógnitas</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grade</translation>
    </message>
    <message>
        <source>analyses</source>
        <translation>análises</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Começar com</translation>
    </message>
    <message>
        <source>first: a mesh of the first size; last: the mesh after the last cycle so far. With most cycles 1 that is one cycle at a time.</source>
        <translation>first: uma malha do primeiro tamanho; last: a malha depois do último ciclo feito. Com no máximo 1 ciclo, é um ciclo por vez.</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Of the adaptive loop; 0: the last analysis.</source>
        <translation>Do laço adaptativo; 0: a última análise.</translation>
    </message>
    <message>
        <source>Rule of sizes</source>
        <translation>Regra de tamanhos</translation>
    </message>
    <message>
        <source>optimal: fewest elements; equal: the same error in each.</source>
        <translation>optimal: o menor número de elementos; equal: o mesmo erro em cada um.</translation>
    </message>
    <message>
        <source>Most cycles</source>
        <translation>Máximo de ciclos</translation>
    </message>
    <message>
        <source>First size</source>
        <translation>Primeiro tamanho</translation>
    </message>
    <message>
        <source>And greatest; 0 takes 1/8 of the domain&apos;s diagonal, or the formula or background mesh alone.</source>
        <translation>E o maior; 0 toma 1/8 da diagonal do domínio, ou só a fórmula ou a malha de fundo.</translation>
    </message>
    <message>
        <source>Least size</source>
        <translation>Menor tamanho</translation>
    </message>
    <message>
        <source>That the loop asks for by itself.</source>
        <translation>Que o laço pede por si.</translation>
    </message>
    <message>
        <source>von Mises stress</source>
        <translation>Tensão de von Mises</translation>
    </message>
    <message>
        <source>Stress sigma_x</source>
        <translation>Tensão sigma_x</translation>
    </message>
    <message>
        <source>Stress sigma_y</source>
        <translation>Tensão sigma_y</translation>
    </message>
    <message>
        <source>Stress tau_xy</source>
        <translation>Tensão tau_xy</translation>
    </message>
    <message>
        <source>Greatest principal stress</source>
        <translation>Maior tensão principal</translation>
    </message>
    <message>
        <source>Least principal stress</source>
        <translation>Menor tensão principal</translation>
    </message>
    <message>
        <source>Displacement along x</source>
        <translation>Deslocamento em x</translation>
    </message>
    <message>
        <source>Displacement along y</source>
        <translation>Deslocamento em y</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Deslocamento</translation>
    </message>
    <message>
        <source>Error of each element</source>
        <translation>Erro de cada elemento</translation>
    </message>
    <message>
        <source>Extremes</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source>Extreme values</source>
        <translation>Valores extremos</translation>
    </message>
    <message>
        <source>displacements</source>
        <translation>deslocamentos</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Isolinhas</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx</translation>
    </message>
    <message>
        <source>min</source>
        <translation>mín</translation>
    </message>
    <message>
        <source>line: a chain of points; polygon: closed; arc: centre and two points, or centre, radius, start, sweep; circle: centre and radius; spline: smooth through the points, closed if the last repeats the first.</source>
        <translation>line: uma cadeia de pontos; polygon: fechada; arc: centro e dois pontos, ou centro, raio, início e varredura; circle: centro e raio; spline: suave pelos pontos, fechada se o último repete o primeiro.</translation>
    </message>
    <message>
        <source>line: a chain of points; arc: centre and two points; spline: smooth through the points.</source>
        <translation>line: uma cadeia de pontos; arc: centro e dois pontos; spline: suave pelos pontos.</translation>
    </message>
    <message>
        <source>Of an arc.</source>
        <translation>De um arco.</translation>
    </message>
    <message>
        <source>Number of element sides along each lip; 0 leaves it to the sizes.</source>
        <translation>Número de lados de elementos em cada lábio; 0 deixa por conta dos tamanhos.</translation>
    </message>
    <message>
        <source>Length of the element sides along the lips; 0 leaves it to the mesh step.</source>
        <translation>Comprimento dos lados dos elementos nos lábios; 0 deixa por conta da etapa de malha.</translation>
    </message>
    <message>
        <source>Of the elements there; 0: no wish.</source>
        <translation>Dos elementos nesse lugar; 0: sem exigência.</translation>
    </message>
    <message>
        <source>inside: where the domain is, and all round a crack; left or right of the base&apos;s direction.</source>
        <translation>inside: onde está o domínio, e em toda a volta de uma trinca; left ou right: à esquerda ou à direita do sentido da base.</translation>
    </message>
    <message>
        <source>ring: as far apart as the curve is from its neighbours; base: as the divided base has them.</source>
        <translation>ring: tão espaçados quanto a curva dista das vizinhas; base: como na base dividida.</translation>
    </message>
    <message>
        <source>Lip</source>
        <translation>Lábio</translation>
    </message>
    <message>
        <source>Curve of the boundary; its tips are NAME_start and NAME_end where the boundary goes straight on. Give what lies ahead a support with normal = 0.</source>
        <translation>Curva do contorno; suas pontas são NOME_start e NOME_end, onde o contorno segue em linha reta. Dê ao que está à frente um apoio com normal = 0.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Região</translation>
    </message>
    <message>
        <source>Empty: every region that has no material of its own.</source>
        <translation>Vazio: toda região sem material próprio.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Módulo de Young</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Coeficiente de Poisson</translation>
    </message>
    <message>
        <source>Below 0.5 in plane strain.</source>
        <translation>Menor que 0,5 em deformação plana.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Onde</translation>
    </message>
    <message>
        <source>Name of a curve, a lip or a point; or a condition, such as &quot;x = 0 and y &gt; 1&quot;.</source>
        <translation>Nome de uma curva, de um lábio ou de um ponto; ou uma condição, como &quot;x = 0 and y &gt; 1&quot;.</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Em x</translation>
    </message>
    <message>
        <source>Prescribed displacement; 0 holds, nothing leaves free.</source>
        <translation>Deslocamento prescrito; 0 prende, vazio deixa livre.</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Em y</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Através</translation>
    </message>
    <message>
        <source>Along the outward normal of the curve; 0 is a line of symmetry.</source>
        <translation>Na normal externa da curva; 0 é uma linha de simetria.</translation>
    </message>
    <message>
        <source>Along x, formula</source>
        <translation>Em x, fórmula</translation>
    </message>
    <message>
        <source>Of x and y; with y or y_formula.</source>
        <translation>De x e y; com y ou y_formula.</translation>
    </message>
    <message>
        <source>Along y, formula</source>
        <translation>Em y, fórmula</translation>
    </message>
    <message>
        <source>Of x and y; with x or x_formula.</source>
        <translation>De x e y; com x ou x_formula.</translation>
    </message>
    <message>
        <source>node: a spring at each node, N/m; bed: along a curve, N/m3.</source>
        <translation>node: uma mola em cada nó, N/m; bed: ao longo de uma curva, N/m3.</translation>
    </message>
    <message>
        <source>Stiffness along x</source>
        <translation>Rigidez em x</translation>
    </message>
    <message>
        <source>Stiffness along y</source>
        <translation>Rigidez em y</translation>
    </message>
    <message>
        <source>Name of a curve, or a condition such as &quot;y = 2&quot;, whose nodes all move alike along `axis`.</source>
        <translation>Nome de uma curva, ou uma condição como &quot;y = 2&quot;, cujos nós se movem todos igualmente ao longo de `axis`.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eixo</translation>
    </message>
    <message>
        <source>Or: sum of coefficient times displacement of these points = value.</source>
        <translation>Ou: soma de coeficiente vezes deslocamento destes pontos = value.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Eixos</translation>
    </message>
    <message>
        <source>&quot;x&quot; or &quot;y&quot;, one a point.</source>
        <translation>&quot;x&quot; ou &quot;y&quot;, um por ponto.</translation>
    </message>
    <message>
        <source>Coefficients</source>
        <translation>Coeficientes</translation>
    </message>
    <message>
        <source>One a point.</source>
        <translation>Um por ponto.</translation>
    </message>
    <message>
        <source>Name of a curve or lip, or a condition such as &quot;x = 0 and y &gt; 1&quot;; of a point (force); of a region, or empty for all (body).</source>
        <translation>Nome de uma curva ou lábio, ou uma condição como &quot;x = 0 and y &gt; 1&quot;; de um ponto (force); de uma região, ou vazio para todas (body).</translation>
    </message>
    <message>
        <source>traction x, y in Pa; pressure: value in Pa, presses on the material (opens a crack by its two lips); force x, y in N at each node; body x, y in N/m3; stress: the exact tractions of a stress field given by formulas; kirsch, l_shape: those of the plate with a hole of `radius` at the origin under a tension `value`, or of the corner of 270 degrees at the origin.</source>
        <translation>traction: x, y em Pa; pressure: value em Pa, comprime o material (abre uma trinca pelos dois lábios); force: x, y em N em cada nó; body: x, y em N/m3; stress: as trações exatas de um campo de tensões dado por fórmulas; kirsch, l_shape: as da placa com furo de `radius` na origem sob tração `value`, ou as do canto de 270 graus na origem.</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Of a linear traction, pressure or body force: x, y, value hold here, x_to, y_to, value_to at `to`.</source>
        <translation>De uma tração, pressão ou força de volume linear: x, y, value valem aqui, x_to, y_to, value_to em `to`.</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Até</translation>
    </message>
    <message>
        <source>x at the end</source>
        <translation>x no fim</translation>
    </message>
    <message>
        <source>y at the end</source>
        <translation>y no fim</translation>
    </message>
    <message>
        <source>Value at the end</source>
        <translation>Valor no fim</translation>
    </message>
    <message>
        <source>x, formula</source>
        <translation>x, fórmula</translation>
    </message>
    <message>
        <source>Of x, y, and of the outward normal nx, ny on a curve: &quot;3 * (1 - y^2)&quot;.</source>
        <translation>De x, y, e da normal externa nx, ny em uma curva: &quot;3 * (1 - y^2)&quot;.</translation>
    </message>
    <message>
        <source>y, formula</source>
        <translation>y, fórmula</translation>
    </message>
    <message>
        <source>Value, formula</source>
        <translation>Valor, fórmula</translation>
    </message>
    <message>
        <source>Of a pressure.</source>
        <translation>De uma pressão.</translation>
    </message>
    <message>
        <source>sigma_x, formula</source>
        <translation>sigma_x, fórmula</translation>
    </message>
    <message>
        <source>Of x and y (stress).</source>
        <translation>De x e y (stress).</translation>
    </message>
    <message>
        <source>sigma_y, formula</source>
        <translation>sigma_y, fórmula</translation>
    </message>
    <message>
        <source>tau_xy, formula</source>
        <translation>tau_xy, fórmula</translation>
    </message>
    <message>
        <source>Bisector</source>
        <translation>Bissetriz</translation>
    </message>
    <message>
        <source>Direction from the corner into the material (l_shape).</source>
        <translation>Direção do canto para dentro do material (l_shape).</translation>
    </message>
    <message>
        <source>Load case</source>
        <translation>Caso de carga</translation>
    </message>
    <message>
        <source>Settlement</source>
        <translation>Recalque</translation>
    </message>
    <message>
        <source>Multiplies prescribed displacements and values of ties in this case; 0: supports stand still.</source>
        <translation>Multiplica deslocamentos prescritos e valores de vínculos neste caso; 0: os apoios ficam parados.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiais</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Apoios</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Molas</translation>
    </message>
    <message>
        <source>Ties</source>
        <translation>Vínculos</translation>
    </message>
    <message>
        <source>Equations between displacements.</source>
        <translation>Equações entre deslocamentos.</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Cargas</translation>
    </message>
    <message>
        <source>Of one load case or several.</source>
        <translation>De um ou mais casos de carga.</translation>
    </message>
    <message>
        <source>Load cases</source>
        <translation>Casos de carga</translation>
    </message>
    <message>
        <source>Only those with settings of their own, or without loads.</source>
        <translation>Só os que têm ajustes próprios, ou não têm cargas.</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno da integral</translation>
    </message>
    <message>
        <source>Outer radius of the ring of the integrals; by default the largest that fits.</source>
        <translation>Raio externo do anel das integrais; por omissão o maior que cabe.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memória</translation>
    </message>
    <message>
        <source>Most that the factorisation may take; 0 takes what the machine has.</source>
        <translation>O máximo que a fatoração pode tomar; 0 toma o que a máquina tem.</translation>
    </message>
    <message>
        <source>Names the table: line_LABEL.csv.</source>
        <translation>Dá nome à tabela: line_LABEL.csv.</translation>
    </message>
    <message>
        <source>Both ends included; those outside the material are left out.</source>
        <translation>Com as duas pontas; os que ficam fora do material são omitidos.</translation>
    </message>
    <message>
        <source>Names the quantities: probe.LABEL.CASE.von_mises.</source>
        <translation>Dá nome às grandezas: probe.LABEL.CASE.von_mises.</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Campo</translation>
    </message>
    <message>
        <source>von Mises, stresses, principal stresses, displacements, or the error of each element.</source>
        <translation>von Mises, tensões, tensões principais, deslocamentos, ou o erro de cada elemento.</translation>
    </message>
    <message>
        <source>The first by default.</source>
        <translation>O primeiro por omissão.</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Deformação</translation>
    </message>
    <message>
        <source>Times the displacements that are drawn: 1 true, 0 none; by default they are a twentieth of the size.</source>
        <translation>Quantas vezes os deslocamentos são desenhados: 1 real, 0 nenhum; por omissão medem um vigésimo do tamanho.</translation>
    </message>
    <message>
        <source>Number of lines.</source>
        <translation>Número de linhas.</translation>
    </message>
    <message>
        <source>Marks the greatest and the least value.</source>
        <translation>Marca o maior e o menor valor.</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Columns of x, y, dx and dy</source>
        <translation>Colunas de x, y, dx e dy</translation>
    </message>
    <message>
        <source>Unit of the file and of the lengths here</source>
        <translation>Unidade do arquivo e dos comprimentos aqui</translation>
    </message>
    <message>
        <source>Thickness before shortening</source>
        <translation>Espessura antes do encurtamento</translation>
    </message>
    <message>
        <source>Their errors</source>
        <translation>Seus erros</translation>
    </message>
    <message>
        <source>Vertices that bound the present width</source>
        <translation>Vértices que limitam a largura atual</translation>
    </message>
    <message>
        <source>Present width</source>
        <translation>Largura atual</translation>
    </message>
    <message>
        <source>Its error</source>
        <translation>Seu erro</translation>
    </message>
    <message>
        <source>Text with columns x, y and, for errors, dx, dy; one vertex a line. Or a polygon in any other format.</source>
        <translation>Texto com colunas x, y e, para os erros, dx, dy; um vértice por linha. Ou um polígono em qualquer outro formato.</translation>
    </message>
    <message>
        <source>In a text file, counted from 1; two leave the errors out.</source>
        <translation>Em um arquivo de texto, contadas a partir de 1; com duas, sem erros.</translation>
    </message>
    <message>
        <source>At the two ends, or one for both.</source>
        <translation>Nas duas extremidades, ou uma só para ambas.</translation>
    </message>
    <message>
        <source>Two numbers counted from 1; the distance along x between them.</source>
        <translation>Dois números contados a partir de 1; a distância entre eles ao longo de x.</translation>
    </message>
    <message>
        <source>Instead of width_points; by default that of the polygon.</source>
        <translation>Em vez de width_points; por padrão, a do polígono.</translation>
    </message>
    <message>
        <source>With width_points the errors of the vertices are used.</source>
        <translation>Com width_points usam-se os erros dos vértices.</translation>
    </message>
    <message>
        <source>Horizon of the target</source>
        <translation>Horizonte do alvo</translation>
    </message>
    <message>
        <source>Datum</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>flat: a horizontal datum; line: the points or the file; horizon: another horizon&apos;s line; regional: the straight line that fits a horizon best; datum: one of the section&apos;s [[input.datum]].</source>
        <translation>flat: um datum horizontal; line: os pontos ou o arquivo; horizon: a linha de outro horizonte; regional: a reta que melhor se ajusta a um horizonte; datum: um dos [[input.datum]] da seção.</translation>
    </message>
    <message>
        <source>For horizon and regional; regional: by default the top.</source>
        <translation>Para horizon e regional; regional: por padrão, o topo.</translation>
    </message>
    <message>
        <source>Its name; by default the only one.</source>
        <translation>Seu nome; por padrão, o único.</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confiança</translation>
    </message>
    <message>
        <source>Horizons that cross</source>
        <translation>Horizontes que se cruzam</translation>
    </message>
    <message>
        <source>Greatest difference of shortening between the beds of a balanced section.</source>
        <translation>Maior diferença de encurtamento entre as camadas de uma seção balanceada.</translation>
    </message>
    <message>
        <source>Of the intervals of the fit.</source>
        <translation>Dos intervalos do ajuste.</translation>
    </message>
    <message>
        <source>Order of the points</source>
        <translation>Ordem dos pontos</translation>
    </message>
    <message>
        <source>Drop points nearer than</source>
        <translation>Descartar pontos mais próximos que</translation>
    </message>
    <message>
        <source>Join gaps below</source>
        <translation>Unir lacunas menores que</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>Desenhado como</translation>
    </message>
    <message>
        <source>Tangents</source>
        <translation>Tangentes</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagem</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidade</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Falhas</translation>
    </message>
    <message>
        <source>Pin lines</source>
        <translation>Linhas de pino</translation>
    </message>
    <message>
        <source>Loose lines</source>
        <translation>Linhas soltas</translation>
    </message>
    <message>
        <source>Unit polygons</source>
        <translation>Polígonos de unidades</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marcadores</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Limite da seção</translation>
    </message>
    <message>
        <source>Topography</source>
        <translation>Topografia</translation>
    </message>
    <message>
        <source>Datums</source>
        <translation>Linhas de datum</translation>
    </message>
    <message>
        <source>Backdrop pictures</source>
        <translation>Imagens de fundo</translation>
    </message>
    <message>
        <source>Horizons above the topography</source>
        <translation>Horizontes acima da topografia</translation>
    </message>
    <message>
        <source>Turn of a chord of a curve</source>
        <translation>Giro de uma corda de uma curva</translation>
    </message>
    <message>
        <source>Longest chord of a curve</source>
        <translation>Maior corda de uma curva</translation>
    </message>
    <message>
        <source>In any format of lines.</source>
        <translation>Em qualquer formato de linhas.</translation>
    </message>
    <message>
        <source>Kinds by names</source>
        <translation>Tipos pelos nomes</translation>
    </message>
    <message>
        <source>Such as &apos;F*=fault&apos;; the first that fits a name goes before the kind that the file gives.</source>
        <translation>Como &apos;F*=falha&apos;; o primeiro que serve a um nome vale mais que o tipo que o arquivo dá.</translation>
    </message>
    <message>
        <source>Eroded lines</source>
        <translation>Linhas erodidas</translation>
    </message>
    <message>
        <source>Drawn dashed and not restored.</source>
        <translation>Desenhadas tracejadas e não restauradas.</translation>
    </message>
    <message>
        <source>Files of many lines</source>
        <translation>Arquivos de várias linhas</translation>
    </message>
    <message>
        <source>Each line becomes what its kind says, a horizon without one.</source>
        <translation>Cada linha torna-se o que seu tipo diz; sem tipo, um horizonte.</translation>
    </message>
    <message>
        <source>Horizons from units</source>
        <translation>Horizontes a partir de unidades</translation>
    </message>
    <message>
        <source>Edges that polygons share become horizons, named by the unit below; none along faults.</source>
        <translation>Lados que polígonos compartilham tornam-se horizontes com o nome da unidade abaixo; nenhum ao longo de falhas.</translation>
    </message>
    <message>
        <source>Snap ends to faults</source>
        <translation>Ajustar extremidades às falhas</translation>
    </message>
    <message>
        <source>Make polygons share edges</source>
        <translation>Fazer os polígonos compartilharem lados</translation>
    </message>
    <message>
        <source>Remove slivers</source>
        <translation>Remover lascas</translation>
    </message>
    <message>
        <source>Length along strike</source>
        <translation>Comprimento ao longo da direção</translation>
    </message>
    <message>
        <source>Of the block that the section stands for: its beds go on like this, into the picture.</source>
        <translation>Do bloco que a seção representa: suas camadas seguem assim, para dentro da figura.</translation>
    </message>
    <message>
        <source>Cut through the block</source>
        <translation>Corte através do bloco</translation>
    </message>
    <message>
        <source>x and y of the beginning and the end of a trace on the map: the section that the vertical plane over it cuts out of the block takes the place of the one that was drawn.</source>
        <translation>x e y do início e do fim de um traço no mapa: a seção que o plano vertical sobre ele corta do bloco toma o lugar da que foi desenhada.</translation>
    </message>
    <message>
        <source>Fold axis</source>
        <translation>Eixo da dobra</translation>
    </message>
    <message>
        <source>In any format of lines; instead of points.</source>
        <translation>Em qualquer formato de linhas; em vez de pontos.</translation>
    </message>
    <message>
        <source>Name of the line in a file that holds several.</source>
        <translation>Nome da linha em um arquivo que contém várias.</translation>
    </message>
    <message>
        <source>In a text file, counted from 1; three for map coordinates with heights.</source>
        <translation>Em um arquivo de texto, contadas a partir de 1; três para coordenadas de mapa com altitudes.</translation>
    </message>
    <message>
        <source>Parts of the same name whose ends are nearer become one line; 0: none.</source>
        <translation>Partes de mesmo nome cujas extremidades estão mais próximas tornam-se uma só linha; 0: nenhuma.</translation>
    </message>
    <message>
        <source>What the points mean: line, corners; hermite, points with tangents; spline, natural through the points (closed if the last repeats the first); bezier, rational_bezier and b_spline, vertices.</source>
        <translation>O que os pontos significam: line, cantos; hermite, pontos com tangentes; spline, natural pelos pontos (fechada se o último repete o primeiro); bezier, rational_bezier e b_spline, vértices.</translation>
    </message>
    <message>
        <source>Of curve = &quot;hermite&quot;, one a point: derivatives along a piece.</source>
        <translation>De curve = &quot;hermite&quot;, uma por ponto: derivadas ao longo de um trecho.</translation>
    </message>
    <message>
        <source>Of curve = &quot;rational_bezier&quot;, one a point, above 0.</source>
        <translation>De curve = &quot;rational_bezier&quot;, um por ponto, acima de 0.</translation>
    </message>
    <message>
        <source>PNG, JPEG or TIFF.</source>
        <translation>PNG, JPEG ou TIFF.</translation>
    </message>
    <message>
        <source>The lower left and the upper right one, in the coordinates of the section&apos;s files; by default as the GeoTIFF or its world file says.</source>
        <translation>O inferior esquerdo e o superior direito, nas coordenadas dos arquivos da seção; por padrão, como diz o GeoTIFF ou seu world file.</translation>
    </message>
    <message>
        <source>One polygon round what belongs to the section; by default it reaches from the first horizon to the last, between their ends.</source>
        <translation>Um polígono em torno do que pertence à seção; por padrão, vai do primeiro horizonte ao último, entre suas extremidades.</translation>
    </message>
    <message>
        <source>Lines that the step target may name.</source>
        <translation>Linhas que a etapa target pode citar.</translation>
    </message>
    <message>
        <source>leave: what is eroded is drawn dashed and not restored; restore: the whole horizon is.</source>
        <translation>leave: o que foi erodido é tracejado e não é restaurado; restore: o horizonte inteiro é restaurado.</translation>
    </message>
    <message>
        <source>Ends of horizons nearer to a fault than this are moved onto it, with a remark; 0: none. Left out, a section joins those that its rounded coordinates have parted.</source>
        <translation>Extremidades de horizontes mais próximas de uma falha que isto são movidas para ela, com uma observação; 0: nenhuma. Sem valor, uma seção une as que suas coordenadas arredondadas separaram.</translation>
    </message>
    <message>
        <source>Their vertices nearer than this to a line or another polygon are moved onto it; 0: none.</source>
        <translation>Seus vértices mais próximos que isto de uma linha ou de outro polígono são movidos para ele; 0: nenhum.</translation>
    </message>
    <message>
        <source>Polygons and spikes of polygons thinner than this are removed, with a remark; 0: none.</source>
        <translation>Polígonos e pontas de polígonos mais finos que isto são removidos, com uma observação; 0: nenhum.</translation>
    </message>
    <message>
        <source>Direction of shear</source>
        <translation>Direção do cisalhamento</translation>
    </message>
    <message>
        <source>Base horizon</source>
        <translation>Horizonte da base</translation>
    </message>
    <message>
        <source>Restored thickness</source>
        <translation>Espessura restaurada</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Where the map is not single-valued</source>
        <translation>Onde o mapa não é unívoco</translation>
    </message>
    <message>
        <source>Surfaces of slip</source>
        <translation>Superfícies de deslizamento</translation>
    </message>
    <message>
        <source>What is kept: constant thickness; variable thickness with its area; the part of the thickness; flexural slip, every bed its length; simple shear; the length of every horizon.</source>
        <translation>O que se conserva: espessura constante; espessura variável com sua área; a fração da espessura; deslizamento flexural, cada camada seu comprimento; cisalhamento simples; o comprimento de cada horizonte.</translation>
    </message>
    <message>
        <source>From the vertical, positive towards +x upwards; 0 is vertical shear.</source>
        <translation>A partir da vertical, positiva para +x para cima; 0 é cisalhamento vertical.</translation>
    </message>
    <message>
        <source>Of proportional thickness; by default the farthest from the top.</source>
        <translation>Da espessura proporcional; por padrão, o mais distante do topo.</translation>
    </message>
    <message>
        <source>Of proportional thickness; by default such that the area stays.</source>
        <translation>Da espessura proporcional; por padrão, a que conserva a área.</translation>
    </message>
    <message>
        <source>0: deformed, 100: restored; between: on the way.</source>
        <translation>0: deformada, 100: restaurada; entre eles: a caminho.</translation>
    </message>
    <message>
        <source>limited: the nearest segment of the top, with a remark, and an error where variable thickness leaves its limits; nearest: without limits; refuse: an error with the place.</source>
        <translation>limited: o segmento mais próximo do topo, com uma observação, e um erro onde a espessura variável passa dos seus limites; nearest: sem limites; refuse: um erro com o lugar.</translation>
    </message>
    <message>
        <source>Of flexural slip: every horizon keeps its length, or every parallel of the top and all areas.</source>
        <translation>Do deslizamento flexural: cada horizonte conserva seu comprimento, ou cada paralela do topo e todas as áreas.</translation>
    </message>
    <message>
        <source>Greatest change of a bed&apos;s length or a unit&apos;s area in a balanced section.</source>
        <translation>Maior variação do comprimento de uma camada ou da área de uma unidade em uma seção balanceada.</translation>
    </message>
    <message>
        <source>Where the section reaches beyond the top</source>
        <translation>Onde a seção ultrapassa o topo</translation>
    </message>
    <message>
        <source>Beyond the top at most</source>
        <translation>Além do topo, no máximo</translation>
    </message>
    <message>
        <source>refuse: an error with the place; continue: the grid goes on straight there.</source>
        <translation>refuse: um erro com o lugar; continue: ali a grade prossegue em linha reta.</translation>
    </message>
    <message>
        <source>So much of the top&apos;s width goes without saying: traces of one section seldom end at one line.</source>
        <translation>Tanto da largura do topo é aceito sem aviso: os traços de uma seção raramente terminam em uma mesma linha.</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Sorteios</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>Error of picks</source>
        <translation>Erro dos pontos digitalizados</translation>
    </message>
    <message>
        <source>Correlation length</source>
        <translation>Comprimento de correlação</translation>
    </message>
    <message>
        <source>Error of the pin&apos;s x</source>
        <translation>Erro do x do pino</translation>
    </message>
    <message>
        <source>Error of the direction of shear</source>
        <translation>Erro da direção do cisalhamento</translation>
    </message>
    <message>
        <source>The same seed gives the same numbers.</source>
        <translation>A mesma semente dá os mesmos números.</translation>
    </message>
    <message>
        <source>Standard deviation of x and z.</source>
        <translation>Desvio-padrão de x e z.</translation>
    </message>
    <message>
        <source>Errors of picks nearer than this along a horizon are alike; by default a twentieth of the section.</source>
        <translation>Erros de pontos mais próximos que isto ao longo de um horizonte são semelhantes; por padrão, um vigésimo da seção.</translation>
    </message>
    <message>
        <source>Of a pin that is given.</source>
        <translation>De um pino que foi dado.</translation>
    </message>
    <message>
        <source>RECON</source>
        <translation>RECON</translation>
    </message>
    <message>
        <source>Error bars</source>
        <translation>Barras de erro</translation>
    </message>
    <message>
        <source>Restores the section again and again with picks, pin and angle drawn from their errors.</source>
        <translation>Restaura a seção repetidas vezes com pontos, pino e ângulo sorteados conforme seus erros.</translation>
    </message>
    <message>
        <source>Balance</source>
        <translation>Balanceamento</translation>
    </message>
    <message>
        <source>Bed lengths, excess areas and the depth of the detachment of the section as it is.</source>
        <translation>Comprimentos das camadas, áreas em excesso e profundidade do descolamento da seção como está.</translation>
    </message>
    <message>
        <source>Join beds</source>
        <translation>Unir camadas</translation>
    </message>
    <message>
        <source>Makes one line of pieces of a horizon that blocks moved back have brought together.</source>
        <translation>Faz uma só linha dos pedaços de um horizonte que blocos movidos de volta aproximaram.</translation>
    </message>
    <message>
        <source>Ends of pieces of one horizon that are nearer than this are joined; by default 0.005 of the section's diagonal.</source>
        <translation>Extremidades de pedaços de um mesmo horizonte mais próximas que isto são unidas; por padrão 0,005 da diagonal da seção.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerância</translation>
    </message>
    <message>
        <source>Whose pieces are joined; by default all.</source>
        <translation>Cujos pedaços são unidos; por padrão todos.</translation>
    </message>
    <message>
        <source>Area balance</source>
        <translation>Balanceamento de áreas</translation>
    </message>
    <message>
        <source>Shortening from the area of a section and the thickness that its layers had, with errors.</source>
        <translation>Encurtamento a partir da área de uma seção e da espessura que suas camadas tinham, com erros.</translation>
    </message>
    <message>
        <source>eroded</source>
        <translation>erodido</translation>
    </message>
    <message>
        <source>det F - 1 [%]</source>
        <translation>det F - 1 [%]</translation>
    </message>
    <message>
        <source>Change of area</source>
        <translation>Variação de área</translation>
    </message>
    <message>
        <source>Strain ellipses</source>
        <translation>Elipses de deformação</translation>
    </message>
    <message>
        <source>Beds</source>
        <translation>Camadas</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>horizonte</translation>
    </message>
    <message>
        <source>length before [m]</source>
        <translation>comprimento antes [m]</translation>
    </message>
    <message>
        <source>after [m]</source>
        <translation>depois [m]</translation>
    </message>
    <message>
        <source>change [%]</source>
        <translation>variação [%]</translation>
    </message>
    <message>
        <source>shortening [m]</source>
        <translation>encurtamento [m]</translation>
    </message>
    <message>
        <source>[%]</source>
        <translation>[%]</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidade</translation>
    </message>
    <message>
        <source>area before [m²]</source>
        <translation>área antes [m²]</translation>
    </message>
    <message>
        <source>after [m²]</source>
        <translation>depois [m²]</translation>
    </message>
    <message>
        <source>thickness before [m]</source>
        <translation>espessura antes [m]</translation>
    </message>
    <message>
        <source>Verdict: </source>
        <translation>Veredito: </translation>
    </message>
    <message>
        <source>Both states to the same scale, no vertical exaggeration.</source>
        <translation>Os dois estados na mesma escala, sem exagero vertical.</translation>
    </message>
    <message>
        <source>x [m]</source>
        <translation>x [m]</translation>
    </message>
    <message>
        <source>z [m]</source>
        <translation>z [m]</translation>
    </message>
    <message>
        <source>... {} more</source>
        <translation>... mais {}</translation>
    </message>
    <message>
        <source>... {} more rows, in the tables (CSV) and the report</source>
        <translation>... mais {} linhas, nas tabelas (CSV) e no relatório</translation>
    </message>
    <message>
        <source>continued</source>
        <translation>continuação</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linhas</translation>
    </message>
    <message>
        <source>Eroded</source>
        <translation>Erodido</translation>
    </message>
    <message>
        <source>strain ellipses are longer than they are drawn; the greatest stretch and its place:</source>
        <translation>elipses de deformação são mais longas do que se desenha; o maior estiramento e seu lugar:</translation>
    </message>
    <message>
        <source>Names of the column</source>
        <translation>Nomes da coluna</translation>
    </message>
    <message>
        <source>x [km]</source>
        <translation>x [km]</translation>
    </message>
    <message>
        <source>z [km]</source>
        <translation>z [km]</translation>
    </message>
    <message>
        <source>Table of colours</source>
        <translation>Tabela de cores</translation>
    </message>
    <message>
        <source>CSV or TOML: name, colour, pattern, age and lithology of units and lines.</source>
        <translation>CSV ou TOML: name (nome), colour (cor), pattern (padrão), age (idade) e lithology (litologia) de unidades e linhas.</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientação</translation>
    </message>
    <message>
        <source>What stands over the left and the right end, such as W - E; told by the plane of lines in space.</source>
        <translation>O que fica sobre o fim esquerdo e o direito, como W - E; o plano de linhas no espaço o diz.</translation>
    </message>
    <message>
        <source>Format version.</source>
        <translation>Versão do formato.</translation>
    </message>
    <message>
        <source>recon or quebra.</source>
        <translation>recon ou quebra.</translation>
    </message>
    <message>
        <source>Piece of the horizon</source>
        <translation>Trecho do horizonte</translation>
    </message>
    <message>
        <source>Name of the horizon that faults have cut this piece from; the pieces add up in the ledger.</source>
        <translation>Nome do horizonte do qual as falhas separaram este trecho; os trechos são somados no balanço.</translation>
    </message>
    <message>
        <source>all pieces</source>
        <translation>todos os trechos</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>partes</translation>
    </message>
    <message>
        <source>The grid stands on the top with fewer points, nowhere farther from it than this; unsteady lines need it.</source>
        <translation>A grade apoia-se no topo com menos pontos, em nenhum lugar mais longe dele que isto; linhas irregulares precisam disto.</translation>
    </message>
    <message>
        <source>refuse: an error with the place; allow: every point goes by the grid all the same, and the units by their faces.</source>
        <translation>refuse: um erro com o lugar; allow: ainda assim cada ponto segue a grade, e as unidades, suas faces.</translation>
    </message>
    <message>
        <source>1 by default.</source>
        <translation>1 por padrão.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolerância dos arcos</translation>
    </message>
    <message>
        <source>Base segment of the step</source>
        <translation>Segmento de base do passo</translation>
    </message>
    <message>
        <source>Between the columns of a text.</source>
        <translation>Entre as colunas de um texto.</translation>
    </message>
    <message>
        <source>Caps</source>
        <translation>Pontas</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Curve so far</source>
        <translation>Curva até aqui</translation>
    </message>
    <message>
        <source>Curves parallel to lines of the model or of a file, or areas about them.</source>
        <translation>Curvas paralelas a linhas do modelo ou de um arquivo, ou áreas em torno delas.</translation>
    </message>
    <message>
        <source>Deleted in the step</source>
        <translation>Removido no passo</translation>
    </message>
    <message>
        <source>Dissolve</source>
        <translation>Dissolver</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distâncias</translation>
    </message>
    <message>
        <source>F of the distances D_k = F D_(k-1) + first distance; 1 (equal gaps) by default.</source>
        <translation>F das distâncias D_k = F D_(k-1) + primeira distância; 1 (intervalos iguais) por padrão.</translation>
    </message>
    <message>
        <source>From the base, instead of the three above.</source>
        <translation>A partir da base, em vez dos três acima.</translation>
    </message>
    <message>
        <source>Greatest distance of a chord from its arc, in D.</source>
        <translation>Maior distância de uma corda ao seu arco, em D.</translation>
    </message>
    <message>
        <source>Greatest distance of a mitre from its corner, in D; 4 by default.</source>
        <translation>Maior distância de uma ponta aguda ao seu vértice, em D; 4 por padrão.</translation>
    </message>
    <message>
        <source>Joins all areas to one; lines get both sides unless the side says otherwise.</source>
        <translation>Une todas as áreas em uma; linhas recebem os dois lados, a menos que o lado diga outra coisa.</translation>
    </message>
    <message>
        <source>Judges the curves independently; exit code 1 if anything is wrong.</source>
        <translation>Julga as curvas de modo independente; código de saída 1 se algo estiver errado.</translation>
    </message>
    <message>
        <source>Mitre limit</source>
        <translation>Limite das pontas agudas</translation>
    </message>
    <message>
        <source>Of a text: numbers from 1, or headers, of x and height, such as &quot;1,2&quot;; of x, y and height for lines in space.</source>
        <translation>De um texto: números a partir de 1, ou cabeçalhos, de x e altura, como &quot;1,2&quot;; de x, y e altura para linhas no espaço.</translation>
    </message>
    <message>
        <source>Of a text: their words name a line, which ends where they change.</source>
        <translation>De um texto: suas palavras dão nome a uma linha, que termina onde elas mudam.</translation>
    </message>
    <message>
        <source>Of an open curve on one side; the longest by default.</source>
        <translation>De uma curva aberta de um lado; o mais longo por padrão.</translation>
    </message>
    <message>
        <source>Of lines and polygons, in any format; by default those of the model.</source>
        <translation>De linhas e polígonos, em qualquer formato; por padrão os do modelo.</translation>
    </message>
    <message>
        <source>Of the coordinates in the file; as the file says otherwise, else as the scenario.</source>
        <translation>Das coordenadas no arquivo; se não dita, como diz o arquivo, ou então o cenário.</translation>
    </message>
    <message>
        <source>Of the first curve from the base; below 0 polygons shrink.</source>
        <translation>Da primeira curva à base; abaixo de 0 os polígonos encolhem.</translation>
    </message>
    <message>
        <source>Of travel: right (default; outside of polygons), left, or both as an area.</source>
        <translation>Do percurso: direito (right, padrão; fora dos polígonos), esquerdo (left), ou ambos (both) como área.</translation>
    </message>
    <message>
        <source>Only the curve of this name or number; all by default.</source>
        <translation>Só a curva deste nome ou número; todas por padrão.</translation>
    </message>
    <message>
        <source>Open ends</source>
        <translation>Extremos abertos</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pedaços</translation>
    </message>
    <message>
        <source>Raw edge of the step</source>
        <translation>Aresta bruta do passo</translation>
    </message>
    <message>
        <source>Raw normals and bisectors: spurious regions stay.</source>
        <translation>Normais e bissetrizes brutas: regiões espúrias ficam.</translation>
    </message>
    <message>
        <source>So many steps of the construction on the subdivision, one raw edge each, for a look at the work; 0 makes the curves.</source>
        <translation>Tantos passos da construção na subdivisão, uma aresta bruta cada, para ver o trabalho; 0 faz as curvas.</translation>
    </message>
    <message>
        <source>Takes every curve as a closed contour.</source>
        <translation>Toma cada curva como um contorno fechado.</translation>
    </message>
    <message>
        <source>The plane of lines in space: x and y of its beginning and its end on the map; found by least squares otherwise.</source>
        <translation>O plano de linhas no espaço: x e y do seu começo e do seu fim no mapa; senão, achado por mínimos quadrados.</translation>
    </message>
    <message>
        <source>To the one before; 0: none but equal ones.</source>
        <translation>Ao anterior; 0: só os iguais.</translation>
    </message>
    <message>
        <source>Unordered points are put in order along their curve, with a remark.</source>
        <translation>Pontos fora de ordem são ordenados ao longo da sua curva, com uma observação.</translation>
    </message>
    <message>
        <source>Untreated</source>
        <translation>Sem tratamento</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>What fills the outer side of a corner.</source>
        <translation>O que preenche o lado externo de um vértice.</translation>
    </message>
    <message>
        <source>With both sides, at the ends of lines; round by default.</source>
        <translation>Com os dois lados, nos extremos das linhas; redondas (round) por padrão.</translation>
    </message>
    <message>
        <source>base curves</source>
        <translation>curvas de base</translation>
    </message>
    <message>
        <source>down, as depths and images do: the height is the reference less the value. As the file says otherwise, else up.</source>
        <translation>down, como em profundidades e imagens: a altura é a referência menos o valor. Se não dito, como diz o arquivo, ou então para cima.</translation>
    </message>
    <message>
        <source>not %1</source>
        <translation>diferente de %1</translation>
    </message>
    <message>
        <source>nothing remains</source>
        <translation>nada resta</translation>
    </message>
    <message>
        <source>trimmed by default: what is nearer than D to any part of the base goes.</source>
        <translation>trimmed por padrão: sai o que está a menos de D de qualquer parte da base.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>WKT</source>
        <translation>WKT</translation>
    </message>
    <message>
        <source>GeoJSON</source>
        <translation>GeoJSON</translation>
    </message>
    <message>
        <source>DXF</source>
        <translation>DXF</translation>
    </message>
    <message>
        <source>MOVE</source>
        <translation>MOVE</translation>
    </message>
    <message>
        <source>GOCAD</source>
        <translation>GOCAD</translation>
    </message>
    <message>
        <source>Shapefile</source>
        <translation>Shapefile</translation>
    </message>
    <message>
        <source>GeoPackage</source>
        <translation>GeoPackage</translation>
    </message>
    <message>
        <source>VTK</source>
        <translation>VTK</translation>
    </message>
    <message>
        <source>VTK: polygons</source>
        <translation>VTK: polígonos</translation>
    </message>
    <message>
        <source>gmsh 4.1</source>
        <translation>gmsh 4.1</translation>
    </message>
    <message>
        <source>gmsh 2.2</source>
        <translation>gmsh 2.2</translation>
    </message>
    <message>
        <source>Abaqus, CalculiX</source>
        <translation>Abaqus, CalculiX</translation>
    </message>
    <message>
        <source>Nastran</source>
        <translation>Nastran</translation>
    </message>
    <message>
        <source>Neutral file</source>
        <translation>Arquivo neutro</translation>
    </message>
    <message>
        <source>Triangle: nodes</source>
        <translation>Triangle: nós</translation>
    </message>
    <message>
        <source>Triangle: elements</source>
        <translation>Triangle: elementos</translation>
    </message>
    <message>
        <source>Triangle: graph</source>
        <translation>Triangle: grafo</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>PLY</source>
        <translation>PLY</translation>
    </message>
    <message>
        <source>STL</source>
        <translation>STL</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>gmsh: geometry</source>
        <translation>gmsh: geometria</translation>
    </message>
    <message>
        <source>SVG</source>
        <translation>SVG</translation>
    </message>
    <message>
        <source>All that can be read</source>
        <translation>Tudo o que pode ser lido</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Figuras</translation>
    </message>
    <message>
        <source>Of x and y: &quot;0.1 + 0.05 * hypot(x, y)&quot;; the least of all sizes counts.</source>
        <translation>De x e y: &quot;0.1 + 0.05 * hypot(x, y)&quot;; vale o menor de todos os tamanhos.</translation>
    </message>
    <message>
        <source>Its elements&apos; sizes, or those of a field of it, are wanted.</source>
        <translation>Valem os tamanhos de seus elementos, ou os de um campo seu.</translation>
    </message>
    <message>
        <source>Name of the field at the points of a VTK mesh that holds sizes in m; empty: the sizes of the elements.</source>
        <translation>Nome do campo nos pontos de uma malha VTK que guarda tamanhos em m; vazio: os tamanhos dos elementos.</translation>
    </message>
    <message>
        <source>even: as few sides as meet size and turn; halving: sides halved until they do, 2:1 along a curve.</source>
        <translation>even: tão poucos lados quanto permitem o tamanho e o giro; halving: lados divididos ao meio até respeitá-los, 2:1 ao longo de uma curva.</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>What places the nodes inside: rows from the boundary inwards, or one by one in a Delaunay triangulation, which is slower.</source>
        <translation>O que põe os nós no interior: fileiras do contorno para dentro, ou um a um numa triangulação de Delaunay, que é mais lenta.</translation>
    </message>
    <message>
        <source>Of element sides: on curves none is longer, inside they are about as long, a few by half. 0 takes 1/20 of the domain&apos;s diagonal on the boundary and the longest side inside, or the formula or background mesh alone.</source>
        <translation>Dos lados dos elementos: nas curvas nenhum é maior; no interior têm mais ou menos esse comprimento, alguns uma vez e meia. 0 toma 1/20 da diagonal do domínio no contorno e o maior lado no interior, ou só a fórmula ou a malha de fundo.</translation>
    </message>
    <message>
        <source>Piece of the fault</source>
        <translation>Trecho da falha</translation>
    </message>
    <message>
        <source>Name of the fault that younger ones have cut this piece from.</source>
        <translation>Nome da falha da qual falhas mais novas separaram este trecho.</translation>
    </message>
    <message>
        <source>Order of age</source>
        <translation>Ordem de idade</translation>
    </message>
    <message>
        <source>1: the youngest fault, which is restored first.</source>
        <translation>1: a falha mais nova, que é restaurada primeiro.</translation>
    </message>
    <message>
        <source>Hanging wall</source>
        <translation>Capa</translation>
    </message>
    <message>
        <source>On which side it lies; auto: above the fault.</source>
        <translation>De que lado fica; auto: acima da falha.</translation>
    </message>
    <message>
        <source>Point in the block</source>
        <translation>Ponto no bloco</translation>
    </message>
    <message>
        <source>Any place between the faults that bound it.</source>
        <translation>Qualquer lugar entre as falhas que o limitam.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Blocks of one group move together.</source>
        <translation>Blocos de um mesmo grupo se movem juntos.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blocos</translation>
    </message>
    <message>
        <source>Names for what faults part; without one, block 1, block 2, ... from the left.</source>
        <translation>Nomes para o que as falhas separam; sem nome, block 1, block 2, ... a partir da esquerda.</translation>
    </message>
    <message>
        <source>Cutoffs and displacement along the faults of the section as it is, and its blocks.</source>
        <translation>Pontos de corte e deslocamento ao longo das falhas da seção como está, e seus blocos.</translation>
    </message>
    <message>
        <source>Tolerance of cutoffs</source>
        <translation>Tolerância dos pontos de corte</translation>
    </message>
    <message>
        <source>Ends of horizons nearer to a fault than this are cut off by it; by default 0.005 of the section&apos;s diagonal.</source>
        <translation>Fins de horizontes mais próximos de uma falha que isto são cortados por ela; por padrão 0,005 da diagonal da seção.</translation>
    </message>
    <message>
        <source>Displacement along faults</source>
        <translation>Deslocamento ao longo das falhas</translation>
    </message>
    <message>
        <source>distance from the higher end [m]</source>
        <translation>distância do fim mais alto [m]</translation>
    </message>
    <message>
        <source>separation [m]</source>
        <translation>separação [m]</translation>
    </message>
    <message>
        <source>Faults and blocks</source>
        <translation>Falhas e blocos</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Falha</translation>
    </message>
    <message>
        <source>Along which the block moves.</source>
        <translation>Ao longo da qual o bloco se move.</translation>
    </message>
    <message>
        <source>rigid: along the straight line from end to end of the fault, or turned about a pivot; shear: inclined simple shear; fault_parallel_flow and flexural_slip: along parallels of the fault, the latter keeps bed lengths; the folds: beds keep their thickness over the bends, or in front of the tip; trishear: slip dies out in a triangle in front of the tip.</source>
        <translation>rigid: ao longo da reta de ponta a ponta da falha, ou girado em torno de um pivô; shear: cisalhamento simples inclinado; fault_parallel_flow e flexural_slip: ao longo de paralelas à falha, este último conserva os comprimentos das camadas; as dobras: as camadas conservam sua espessura sobre as quebras da falha, ou à frente da ponta; trishear: o rejeito se extingue num triângulo à frente da ponta.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>restore: to an earlier state; forward: to a later one.</source>
        <translation>restore: para um estado anterior; forward: para um posterior.</translation>
    </message>
    <message>
        <source>That move, or groups of them; by default all of the hanging wall.</source>
        <translation>Que se movem, ou grupos deles; por padrão toda a capa.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ângulo</translation>
    </message>
    <message>
        <source>Of shear: its direction from the vertical, positive leaning to +x; rigid: anticlockwise turn.</source>
        <translation>Do cisalhamento: sua direção a partir da vertical, positiva inclinada para +x; rigid: giro anti-horário.</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivô</translation>
    </message>
    <message>
        <source>About which a rigid block turns.</source>
        <translation>Em torno do qual um bloco rígido gira.</translation>
    </message>
    <message>
        <source>Up along the fault</source>
        <translation>Para cima ao longo da falha</translation>
    </message>
    <message>
        <source>Of a fault with level ends: the way that its hanging wall goes for a slip above 0.</source>
        <translation>De uma falha com pontas no mesmo nível: para onde vai sua capa com um rejeito acima de 0.</translation>
    </message>
    <message>
        <source>How far ends of lines are taken to the fault; by default 0.005 of the section&apos;s diagonal.</source>
        <translation>Até que distância extremidades de linhas são levadas à falha; por padrão 0,005 da diagonal da seção.</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Rejeito</translation>
    </message>
    <message>
        <source>Of the hanging wall along the fault; positive raises it.</source>
        <translation>Da capa ao longo da falha; positivo a eleva.</translation>
    </message>
    <message>
        <source>Heave</source>
        <translation>Rejeito horizontal</translation>
    </message>
    <message>
        <source>Instead: horizontally; positive raises the hanging wall.</source>
        <translation>Em vez disso: na horizontal; positivo eleva a capa.</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>Rejeito vertical</translation>
    </message>
    <message>
        <source>Instead: vertically; positive raises the hanging wall.</source>
        <translation>Em vez disso: na vertical; positivo eleva a capa.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Instead: horizons whose cutoffs are to meet; of several by least squares.</source>
        <translation>Em vez disso: horizontes cujos pontos de corte devem se encontrar; vários, por mínimos quadrados.</translation>
    </message>
    <message>
        <source>Measured at</source>
        <translation>Medido em</translation>
    </message>
    <message>
        <source>Horizon at whose cutoff in the hanging wall the slip is measured; by default the uppermost.</source>
        <translation>Horizonte em cujo ponto de corte na capa o rejeito é medido; por padrão o mais alto.</translation>
    </message>
    <message>
        <source>Apical angle</source>
        <translation>Ângulo apical</translation>
    </message>
    <message>
        <source>Of trishear: the full angle of the triangle.</source>
        <translation>Do trishear: o ângulo inteiro do triângulo.</translation>
    </message>
    <message>
        <source>Kinematics from beds</source>
        <translation>Cinemática a partir de camadas</translation>
    </message>
    <message>
        <source>Finds the values of trishear, or of inclined shear, that take the beds of a fold back to straight lines best.</source>
        <translation>Encontra os valores de trishear, ou de cisalhamento inclinado, que melhor levam as camadas de uma dobra de volta a linhas retas.</translation>
    </message>
    <message>
        <source>trishear: a fold in front of the tip of a fault; shear: inclined simple shear over a known fault.</source>
        <translation>trishear: uma dobra à frente da ponta de uma falha; shear: cisalhamento simples inclinado sobre uma falha conhecida.</translation>
    </message>
    <message>
        <source>Horizons, pieces and all, that are to become straight; by default all.</source>
        <translation>Horizontes, com todos os seus trechos, que devem ficar retos; por padrão todos.</translation>
    </message>
    <message>
        <source>Of shear: over which it goes; of trishear: whose tip and ramp are taken.</source>
        <translation>Do cisalhamento: sobre a qual ele se dá; do trishear: da qual se tomam a ponta e a rampa.</translation>
    </message>
    <message>
        <source>Tip x</source>
        <translation>x da ponta</translation>
    </message>
    <message>
        <source>Of trishear: of the tip as it is; one number fixes it, two are limits.</source>
        <translation>Do trishear: da ponta como está; um número a fixa, dois são limites.</translation>
    </message>
    <message>
        <source>Tip z</source>
        <translation>z da ponta</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Of trishear: direction in which the tip goes, anticlockwise from +x; one number or limits.</source>
        <translation>Do trishear: direção em que a ponta avança, anti-horária a partir de +x; um número ou limites.</translation>
    </message>
    <message>
        <source>P/S</source>
        <translation>P/S</translation>
    </message>
    <message>
        <source>Of trishear: how far the tip goes a metre of slip.</source>
        <translation>Do trishear: quanto a ponta avança por metro de rejeito.</translation>
    </message>
    <message>
        <source>Of trishear: how far the tip goes a metre of slip; one number or limits.</source>
        <translation>Do trishear: quanto a ponta avança por metro de deslizamento; um número ou limites.</translation>
    </message>
    <message>
        <source>Of trishear: the full angle of the triangle; one number or limits.</source>
        <translation>Do trishear: o ângulo inteiro do triângulo; um número ou limites.</translation>
    </message>
    <message>
        <source>That made the fold, along the fault; positive raised the hanging wall. One number or limits.</source>
        <translation>O que fez a dobra, ao longo da falha; positivo ergueu a capa. Um número ou limites.</translation>
    </message>
    <message>
        <source>Concentration</source>
        <translation>Concentração</translation>
    </message>
    <message>
        <source>Of trishear: 1 shears evenly, more gathers strain in the middle of the triangle.</source>
        <translation>Do trishear: 1 cisalha por igual, mais concentra a deformação no meio do triângulo.</translation>
    </message>
    <message>
        <source>Ramp angle</source>
        <translation>Ângulo da rampa</translation>
    </message>
    <message>
        <source>Of a fault-propagation fold whose fault has its flat alone yet.</source>
        <translation>De uma dobra de propagação de falha cuja falha só tem ainda o patamar.</translation>
    </message>
    <message>
        <source>Of trishear: one number or limits; by default 1.</source>
        <translation>Do trishear: um número ou limites; por padrão 1.</translation>
    </message>
    <message>
        <source>Of shear: its direction from the vertical, positive leaning to +x; one number or limits.</source>
        <translation>Do cisalhamento: a sua direção a partir da vertical, positiva inclinada para +x; um número ou limites.</translation>
    </message>
    <message>
        <source>Bedding</source>
        <translation>Acamamento</translation>
    </message>
    <message>
        <source>Of a fault-bend fold: direction of the undeformed beds; by default along the lowest segment.</source>
        <translation>De uma dobra de flexão de falha: direção das camadas não deformadas; por padrão ao longo do segmento mais baixo.</translation>
    </message>
    <message>
        <source>Slip before</source>
        <translation>Rejeito anterior</translation>
    </message>
    <message>
        <source>Of a fault-bend fold: slip that the fault had at the earlier of the two states.</source>
        <translation>De uma dobra de flexão de falha: rejeito que a falha tinha no estado anterior dos dois.</translation>
    </message>
    <message>
        <source>Move on fault</source>
        <translation>Mover pela falha</translation>
    </message>
    <message>
        <source>Moves blocks along a fault, back to an earlier state or on to a later one.</source>
        <translation>Move blocos ao longo de uma falha, de volta a um estado anterior ou adiante a um posterior.</translation>
    </message>
    <message>
        <source>Block that moves</source>
        <translation>Bloco que se move</translation>
    </message>
    <message>
        <source>Fault of the move</source>
        <translation>Falha do movimento</translation>
    </message>
    <message>
        <source>Section after the move</source>
        <translation>Seção após o movimento</translation>
    </message>
    <message>
        <source>Section after move</source>
        <translation>Seção após o movimento</translation>
    </message>
    <message>
        <source>0 is the input, k the section after k restorations and moves.</source>
        <translation>0 é a entrada, k a seção após k restaurações e movimentos.</translation>
    </message>
    <message>
        <source>Only these, or groups of them, are restored, each with a pin of its own; the rest stays.</source>
        <translation>Só estes, ou grupos deles, são restaurados, cada um com seu próprio pino; o resto fica.</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Quebra-cabeça</translation>
    </message>
    <message>
        <source>Every block is restored with a pin of its own, then they slide together.</source>
        <translation>Cada bloco é restaurado com seu próprio pino; depois eles deslizam até se juntarem.</translation>
    </message>
    <message>
        <source>Points of the target</source>
        <translation>Pontos do alvo</translation>
    </message>
    <message>
        <source>Instead of a level datum: the line that the top of every block is restored to, such as a regional dip or the topography.</source>
        <translation>Em vez de um datum horizontal: a linha à qual o topo de cada bloco é restaurado, como um mergulho regional ou a topografia.</translation>
    </message>
    <message>
        <source>Constraint of the blocks</source>
        <translation>Vínculo dos blocos</translation>
    </message>
    <message>
        <source>Of the jigsaw. datum: each block is unfolded to the datum, then they slide along it; rotation: without a datum, rigid blocks turn and shift.</source>
        <translation>Do quebra-cabeça. datum: cada bloco é desdobrado até o datum, depois eles deslizam ao longo dele; rotation: sem datum, blocos rígidos giram e se deslocam.</translation>
    </message>
    <message>
        <source>Blocks fit by</source>
        <translation>Blocos ajustados por</translation>
    </message>
    <message>
        <source>Of the jigsaw. walls (the default): the walls of all faults lie as near to each other as can be; top: the ends of the top meet.</source>
        <translation>Do quebra-cabeça. walls (o padrão): as paredes de todas as falhas ficam tão próximas quanto possível; top: as pontas do topo se encontram.</translation>
    </message>
    <message>
        <source>Top horizon of the blocks</source>
        <translation>Horizonte de topo dos blocos</translation>
    </message>
    <message>
        <source>Restored to the datum in every block; by default the first. With block or jigsaw, which need no steps grid and target.</source>
        <translation>Restaurado ao datum em cada bloco; por padrão o primeiro. Com block ou jigsaw, que dispensam as etapas grid e target.</translation>
    </message>
    <message>
        <source>Of the block that it lies in, which stays where it is; by default the leftmost block, pinned near its middle, as the others are.</source>
        <translation>Do bloco em que está, que fica no lugar; por padrão o bloco mais à esquerda, com o pino perto do meio, como os outros.</translation>
    </message>
    <message>
        <source>The top of every block with fewer points, nowhere farther from it than this.</source>
        <translation>O topo de cada bloco com menos pontos, em nenhum lugar mais longe dele do que isto.</translation>
    </message>
    <message>
        <source>How far ends of lines are taken to the faults; by default 0.005 of the section's diagonal.</source>
        <translation>Até que distância as pontas de linhas são levadas às falhas; por padrão 0,005 da diagonal da seção.</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pinos</translation>
    </message>
    <message>
        <source>Direction that restored beds have, anticlockwise from +x; by default each bed has its own.</source>
        <translation>Direção que as camadas restauradas têm, anti-horária a partir de +x; por padrão cada camada tem a sua.</translation>
    </message>
    <message>
        <source>Of the limits.</source>
        <translation>Dos limites.</translation>
    </message>
    <message>
        <source>Map of the misfit</source>
        <translation>Mapa do desajuste</translation>
    </message>
    <message>
        <source>Two of the values that are sought, one after the other, such as propagation and apical.</source>
        <translation>Dois dos valores procurados, um após o outro, como propagation e apical.</translation>
    </message>
    <message>
        <source>Points of the map</source>
        <translation>Pontos do mapa</translation>
    </message>
    <message>
        <source>Along each side.</source>
        <translation>Ao longo de cada lado.</translation>
    </message>
    <message>
        <source>Of the search.</source>
        <translation>Da busca.</translation>
    </message>
    <message>
        <source>Generations</source>
        <translation>Gerações</translation>
    </message>
    <message>
        <source>Of the search, at the most.</source>
        <translation>Da busca, no máximo.</translation>
    </message>
    <message>
        <source>Ramp found</source>
        <translation>Rampa encontrada</translation>
    </message>
    <message>
        <source>Trishear zone</source>
        <translation>Zona de trishear</translation>
    </message>
    <message>
        <source>Kinematics found</source>
        <translation>Cinemática encontrada</translation>
    </message>
    <message>
        <source>Beds restored</source>
        <translation>Camadas restauradas</translation>
    </message>
    <message>
        <source>misfit [m]</source>
        <translation>desajuste [m]</translation>
    </message>
    <message>
        <source>Misfit</source>
        <translation>Desajuste</translation>
    </message>
    <message>
        <source>Region of confidence</source>
        <translation>Região de confiança</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Melhor</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Previsão</translation>
    </message>
    <message>
        <source>The deep part of a fault from a rollover, a rollover over a fault, or the angles of a fold from its dips.</source>
        <translation>A parte profunda de uma falha a partir de um rollover, um rollover sobre uma falha, ou os ângulos de uma dobra a partir dos seus mergulhos.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>fault: the deep part of a normal fault from the rollover of a bed; rollover: a bed over a known fault; the folds: their angles from the dips of their limbs.</source>
        <translation>fault: a parte profunda de uma falha normal a partir do rollover de uma camada; rollover: uma camada sobre uma falha conhecida; as dobras: os seus ângulos a partir dos mergulhos dos flancos.</translation>
    </message>
    <message>
        <source>Of fault and rollover: its name.</source>
        <translation>De fault e rollover: o seu nome.</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>Camada</translation>
    </message>
    <message>
        <source>Horizon that has cutoffs on the fault; of rollover: that on the footwall.</source>
        <translation>Horizonte que tem terminações na falha; do rollover: a da lapa.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Of rollover, instead of a bed: of the regional at the fault.</source>
        <translation>Do rollover, em vez de uma camada: do regional na falha.</translation>
    </message>
    <message>
        <source>Of rollover: along the fault at the regional; negative lets the hanging wall down.</source>
        <translation>Do rollover: ao longo da falha no regional; negativo abaixa a capa.</translation>
    </message>
    <message>
        <source>Of rollover, instead: horizontally; negative lets the hanging wall down.</source>
        <translation>Do rollover, em vez disso: na horizontal; negativo abaixa a capa.</translation>
    </message>
    <message>
        <source>Direction of shear from the vertical, positive leaning to +x.</source>
        <translation>Direção do cisalhamento a partir da vertical, positiva inclinada para +x.</translation>
    </message>
    <message>
        <source>Direction of the regional, anticlockwise from +x.</source>
        <translation>Direção do regional, anti-horária a partir de +x.</translation>
    </message>
    <message>
        <source>Dip of the backlimb</source>
        <translation>Mergulho do flanco traseiro</translation>
    </message>
    <message>
        <source>Of the folds: from the level beds.</source>
        <translation>Das dobras: a partir das camadas horizontais.</translation>
    </message>
    <message>
        <source>Dip of the forelimb</source>
        <translation>Mergulho do flanco frontal</translation>
    </message>
    <message>
        <source>Of the folds: from the level beds; above 90 it is overturned.</source>
        <translation>Das dobras: a partir das camadas horizontais; acima de 90 está invertido.</translation>
    </message>
    <message>
        <source>Regional</source>
        <translation>Regional</translation>
    </message>
    <message>
        <source>Bed predicted</source>
        <translation>Camada prevista</translation>
    </message>
    <message>
        <source>Fault predicted</source>
        <translation>Falha prevista</translation>
    </message>
    <message>
        <source>not done: %1</source>
        <translation>não feito: %1</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was read here.</source>
        <translation>Outro programa alterou %1 depois de ter sido lido aqui.</translation>
    </message>
    <message>
        <source>Saving to it loses those changes.</source>
        <translation>Salvar nele perde essas alterações.</translation>
    </message>
    <message>
        <source>Save as another file</source>
        <translation>Salvar em outro arquivo</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescrever</translation>
    </message>
    <message>
        <source>%1 of %2 %3</source>
        <translation>%1 de %2 %3</translation>
    </message>
    <message>
        <source>to be given</source>
        <translation>a informar</translation>
    </message>
    <message>
        <source>Still to be given: %1</source>
        <translation>Falta informar: %1</translation>
    </message>
    <message>
        <source>Click the first point, or type x,z</source>
        <translation>Clique no primeiro ponto, ou digite x,z</translation>
    </message>
    <message>
        <source>Click the next point, or type @dx,dz; Enter ends, Backspace takes a point back</source>
        <translation>Clique no próximo ponto, ou digite @dx,dz; Enter termina, Backspace desfaz um ponto</translation>
    </message>
    <message>
        <source>Click a corner</source>
        <translation>Clique num canto</translation>
    </message>
    <message>
        <source>Click the opposite corner</source>
        <translation>Clique no canto oposto</translation>
    </message>
    <message>
        <source>Click the centre</source>
        <translation>Clique no centro</translation>
    </message>
    <message>
        <source>Click a point of the circle</source>
        <translation>Clique num ponto da circunferência</translation>
    </message>
    <message>
        <source>Click the point</source>
        <translation>Clique no ponto</translation>
    </message>
    <message>
        <source>Click points: length and direction of each way, and from the third point on the area</source>
        <translation>Clique em pontos: comprimento e direção de cada trecho; a partir do terceiro, a área</translation>
    </message>
    <message>
        <source>A closed line needs three points that do not lie in line</source>
        <translation>Uma linha fechada precisa de três pontos não alinhados</translation>
    </message>
    <message>
        <source>A line needs two points</source>
        <translation>Uma linha precisa de dois pontos</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no place; type x,z or @dx,dz or @distance&lt;degrees or a length</source>
        <translation>&apos;{}&apos; não é um lugar; digite x,z ou @dx,dz ou @distância&lt;graus ou um comprimento</translation>
    </message>
    <message>
        <source>there is no place before to measure from; type x,z</source>
        <translation>não há lugar anterior a partir do qual medir; digite x,z</translation>
    </message>
    <message>
        <source>a length needs a direction: move the cursor to where the line is to go</source>
        <translation>um comprimento precisa de direção: leve o cursor para onde a linha deve ir</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>vértice</translation>
    </message>
    <message>
        <source>intersection</source>
        <translation>interseção</translation>
    </message>
    <message>
        <source>on line</source>
        <translation>sobre a linha</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>perpendicular</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>grade</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ângulo</translation>
    </message>
    <message>
        <source>Click where the direction to the right is to point, or type degrees</source>
        <translation>Clique para onde deve apontar a direção da direita, ou digite graus</translation>
    </message>
    <message>
        <source>Click a second point of the mirror line</source>
        <translation>Clique num segundo ponto da linha de espelho</translation>
    </message>
    <message>
        <source>Click where it is to go, or type @dx,dz</source>
        <translation>Clique aonde deve ir, ou digite @dx,dz</translation>
    </message>
    <message>
        <source>Select lines, then click the point to turn them about</source>
        <translation>Selecione linhas e clique no ponto em torno do qual girá-las</translation>
    </message>
    <message>
        <source>Select lines, then click a point of the mirror line</source>
        <translation>Selecione linhas e clique num ponto da linha de espelho</translation>
    </message>
    <message>
        <source>Select lines, then click the point to take them by</source>
        <translation>Selecione linhas e clique no ponto por onde pegá-las</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nada está selecionado</translation>
    </message>
    <message>
        <source>Rotate lines</source>
        <translation>Girar linhas</translation>
    </message>
    <message>
        <source>Mirror lines</source>
        <translation>Espelhar linhas</translation>
    </message>
    <message>
        <source>Changed by</source>
        <translation>Mudança</translation>
    </message>
    <message>
        <source>Drag the place where the top is held; the restoration follows</source>
        <translation>Arrasta o lugar em que o topo é fixado; a restauração acompanha</translation>
    </message>
    <message>
        <source>Press on the section and drag to where the top is held; Escape gives up</source>
        <translation>Pressione na seção e arraste até onde o topo é fixado; Esc desiste</translation>
    </message>
    <message>
        <source>There is nothing to pin: the scenario has no step &apos;Target&apos;.</source>
        <translation>Não há o que fixar: o cenário não tem uma etapa não tem uma etapa &apos;Alvo&apos;apos;Destinonão tem uma etapa &apos;Alvo&apos;apos;.</translation>
    </message>
    <message>
        <source>The pin stands on the section that is restored; press there, in its own panel.</source>
        <translation>O ponto fixo fica na seção que é restaurada; pressione nela, em seu próprio painel.</translation>
    </message>
    <message>
        <source>Move the pin</source>
        <translation>Mover o ponto fixo</translation>
    </message>
    <message>
        <source>States compared</source>
        <translation>Estados comparados</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Depois</translation>
    </message>
    <message>
        <source>The input and the last state</source>
        <translation>A entrada e o último estado</translation>
    </message>
    <message>
        <source>The input and state 1</source>
        <translation>A entrada e o estado 1</translation>
    </message>
    <message>
        <source>States %1 and %2</source>
        <translation>Os estados %1 e %2</translation>
    </message>
    <message>
        <source>Nothing is restored or moved yet, so that there is nothing to compare.</source>
        <translation>Nada foi restaurado nem movido ainda; não há o que comparar.</translation>
    </message>
    <message>
        <source>Balanced: no bed and no unit changed by more than %1 %.</source>
        <translation>Balanceado: nenhuma camada e nenhuma unidade mudou mais de %1 %.</translation>
    </message>
    <message>
        <source>Not balanced: what changed by more than %1 % is marked.</source>
        <translation>Não balanceado: o que mudou mais de %1 % está marcado.</translation>
    </message>
    <message>
        <source>Length of the bed</source>
        <translation>Comprimento da camada</translation>
    </message>
    <message>
        <source>Area of the unit</source>
        <translation>Área da unidade</translation>
    </message>
    <message>
        <source> (not judged)</source>
        <translation> (não julgado)</translation>
    </message>
    <message>
        <source>beyond the tolerance</source>
        <translation>além da tolerância</translation>
    </message>
    <message>
        <source>Draws a crack, from the border or inside, with its length and its angle to the border</source>
        <translation>Desenha uma trinca, a partir do contorno ou por dentro, com seu comprimento e seu ângulo com o contorno</translation>
    </message>
    <message>
        <source>Click where the crack begins; near the border it begins on the border</source>
        <translation>Clique onde a trinca começa; perto do contorno, ela começa no contorno</translation>
    </message>
    <message>
        <source>Click the next point, or type @d&lt;angle; Enter ends the crack, Backspace takes a point back</source>
        <translation>Clique o próximo ponto, ou digite @d&lt;ângulo; Enter termina a trinca, Backspace retira um ponto</translation>
    </message>
    <message>
        <source>{:.6g} {} long</source>
        <translation>{:.6g} {} de comprimento</translation>
    </message>
    <message>
        <source>{:.1f}° to the border</source>
        <translation>{:.1f}° com o contorno</translation>
    </message>
    <message>
        <source>A crack has two points or more</source>
        <translation>Uma trinca tem dois pontos ou mais</translation>
    </message>
    <message>
        <source>There are no cracks. The tool Crack (K) draws one.</source>
        <translation>Não há trincas. A ferramenta Trinca (K) desenha uma.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>This picture does not show the crack; look at the input (Ctrl+1), or show the layer of cracks.</source>
        <translation>Esta figura não mostra a trinca; veja a entrada (Ctrl+1), ou mostre a camada das trincas.</translation>
    </message>
    <message>
        <source>Move lines</source>
        <translation>Mover linhas</translation>
    </message>
    <message>
        <source>Click a line, or drag a box round lines; drag a vertex to move it, Delete removes it</source>
        <translation>Clique numa linha ou arraste uma caixa; mova um vértice; Delete remove</translation>
    </message>
    <message>
        <source>Move vertex</source>
        <translation>Mover vértice</translation>
    </message>
    <message>
        <source>Delete vertices</source>
        <translation>Remover vértices</translation>
    </message>
    <message>
        <source>Delete lines</source>
        <translation>Remover linhas</translation>
    </message>
    <message>
        <source>Click a line where it is to have one more vertex</source>
        <translation>Clique na linha onde ela deve ter mais um vértice</translation>
    </message>
    <message>
        <source>Click a line where it is to be split</source>
        <translation>Clique na linha onde ela deve ser dividida</translation>
    </message>
    <message>
        <source>Click the line to join it with</source>
        <translation>Clique na linha com que uni-la</translation>
    </message>
    <message>
        <source>Click a line near the end to join</source>
        <translation>Clique numa linha perto da ponta a unir</translation>
    </message>
    <message>
        <source>Click a line near the end that is to go on to the next line</source>
        <translation>Clique numa linha perto da ponta que deve seguir até a próxima linha</translation>
    </message>
    <message>
        <source>Click the part of a line that is to go</source>
        <translation>Clique na parte da linha que deve sair</translation>
    </message>
    <message>
        <source>There is no line here</source>
        <translation>Não há linha aqui</translation>
    </message>
    <message>
        <source>Join lines</source>
        <translation>Unir linhas</translation>
    </message>
    <message>
        <source>too few points would be left; delete the whole line instead</source>
        <translation>sobrariam poucos pontos; remova a linha inteira</translation>
    </message>
    <message>
        <source>a line is not split at its end</source>
        <translation>uma linha não é dividida na sua ponta</translation>
    </message>
    <message>
        <source>a closed line has no end to join</source>
        <translation>uma linha fechada não tem ponta a unir</translation>
    </message>
    <message>
        <source>a closed line has no end to extend</source>
        <translation>uma linha fechada não tem ponta a prolongar</translation>
    </message>
    <message>
        <source>the line, drawn straight on, meets no other line</source>
        <translation>a linha, prolongada em reta, não encontra nenhuma outra</translation>
    </message>
    <message>
        <source>a closed line is not trimmed; split it first</source>
        <translation>uma linha fechada não é aparada; divida-a antes</translation>
    </message>
    <message>
        <source>the line meets no other line here, so there is nothing to trim it at</source>
        <translation>a linha não encontra outra aqui, por isso não há onde apará-la</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>A step has made this; edit the section as it was read.</source>
        <translation>Isto foi feito por um passo; edite a seção como foi lida.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Desenhar</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selecionar</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linha</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Retângulo</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Insert vertex</source>
        <translation>Inserir vértice</translation>
    </message>
    <message>
        <source>Split line</source>
        <translation>Dividir linha</translation>
    </message>
    <message>
        <source>Extend line</source>
        <translation>Prolongar linha</translation>
    </message>
    <message>
        <source>Trim line</source>
        <translation>Aparar linha</translation>
    </message>
    <message>
        <source>Copy lines</source>
        <translation>Copiar linhas</translation>
    </message>
    <message>
        <source>Snap to lines</source>
        <translation>Atrair para linhas</translation>
    </message>
    <message>
        <source>Snap to vertices, crossings and lines (F3); not while Alt is held</source>
        <translation>Atrair para vértices, cruzamentos e linhas (F3); não enquanto Alt está pressionada</translation>
    </message>
    <message>
        <source>Draw at multiples of 15°</source>
        <translation>Desenhar em múltiplos de 15°</translation>
    </message>
    <message>
        <source>Draw &apos;%1&apos;</source>
        <translation>Desenhar &apos;%1&apos;</translation>
    </message>
    <message>
        <source>What was drawn?</source>
        <translation>O que foi desenhado?</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Desenhar</translation>
    </message>
    <message>
        <source>this is drawn by the program and cannot be edited; edit horizons, faults and lines</source>
        <translation>isto é desenhado pelo programa e não pode ser editado; edite horizontes, falhas e linhas</translation>
    </message>
    <message>
        <source>reading the section has made or cut this line, so that it cannot be edited by itself; edit the line that it was made from</source>
        <translation>a leitura da seção fez ou cortou esta linha, e ela não pode ser editada sozinha; edite a linha de que foi feita</translation>
    </message>
    <message>
        <source>give it a name</source>
        <translation>dê-lhe um nome</translation>
    </message>
    <message>
        <source>another one has this name already; give another name</source>
        <translation>outro já tem este nome; dê outro nome</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>Horizonte</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno externo</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Furo</translation>
    </message>
    <message>
        <source>Crack</source>
        <translation>Trinca</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Linha interna</translation>
    </message>
    <message>
        <source>Part of the boundary</source>
        <translation>Parte do contorno</translation>
    </message>
    <message>
        <source>this is drawn by the program and cannot be edited; edit curves and cracks</source>
        <translation>isto é desenhado pelo programa e não pode ser editado; edite curvas e trincas</translation>
    </message>
    <message>
        <source>arcs, circles and splines move as a whole here; change their shape in the form</source>
        <translation>arcos, círculos e splines se movem aqui como um todo; mude a forma deles no formulário</translation>
    </message>
    <message>
        <source>a file or a specimen holds this curve, not the scenario; change it there</source>
        <translation>um arquivo ou um corpo de prova contém esta curva, não o cenário; mude-a lá</translation>
    </message>
    <message>
        <source>Loose line</source>
        <translation>Linha solta</translation>
    </message>
    <message>
        <source>Unit polygon</source>
        <translation>Polígono de unidade</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marcador</translation>
    </message>
    <message>
        <source>Open a scenario (Ctrl+O), drop one here, or draw the first line (L).</source>
        <translation>Abra um cenário (Ctrl+O), solte um aqui, ou desenhe a primeira linha (L).</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;recente</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Nenhum ainda</translation>
    </message>
    <message>
        <source>Changes were not saved when the program last ended.</source>
        <translation>Havia alterações não salvas quando o programa terminou.</translation>
    </message>
    <message>
        <source>Take them up again? Undo gives back what was saved.</source>
        <translation>Retomá-las? Desfazer devolve o que foi salvo.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Recover what was not saved</source>
        <translation>Recuperar o que não foi salvo</translation>
    </message>
    <message>
        <source>Changes are not kept for a crash: %1</source>
        <translation>As alterações não são guardadas para uma queda: %1</translation>
    </message>
    <message>
        <source>there is nothing to recover</source>
        <translation>não há nada a recuperar</translation>
    </message>
    <message>
        <source>Arrow keys pan, + and - zoom, Home shows all; with Space held the left button pans.</source>
        <translation>As setas deslocam, + e - ampliam e reduzem, Home mostra tudo; com Espaço, o botão esquerdo desloca.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observações</translation>
    </message>
    <message>
        <source>no tool &apos;%1&apos;</source>
        <translation>não há ferramenta &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no picture to point at</source>
        <translation>não há figura em que apontar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos; não é um número</translation>
    </message>
    <message>
        <source>A step has made this; show the input to edit it (menu View, or Ctrl+1).</source>
        <translation>Isto foi feito por uma etapa; mostre a entrada para editá-la (menu Exibir, ou Ctrl+1).</translation>
    </message>
    <message>
        <source>Nothing is selected: take up Select (S) and click a line first.</source>
        <translation>Nada está selecionado: pegue Selecionar (S) e clique antes em uma linha.</translation>
    </message>
    <message>
        <source>There is no line here.</source>
        <translation>Não há linha aqui.</translation>
    </message>
    <message>
        <source>This is the line itself.</source>
        <translation>Esta é a própria linha.</translation>
    </message>
    <message>
        <source>Which of the two is the line that they become?</source>
        <translation>Qual das duas é a linha em que elas se tornam?</translation>
    </message>
    <message>
        <source>write look input, result or both</source>
        <translation>escreva look input, result ou both</translation>
    </message>
    <message>
        <source>one under %1</source>
        <translation>um em %1</translation>
    </message>
    <message>
        <source>The input</source>
        <translation>A entrada</translation>
    </message>
    <message>
        <source>The result</source>
        <translation>O resultado</translation>
    </message>
    <message>
        <source>Input and result</source>
        <translation>Entrada e resultado</translation>
    </message>
    <message>
        <source>&amp;Undo: last point</source>
        <translation>&amp;Desfazer: último ponto</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Such as #1a2b3c; by default the usual ones, one after the other.</source>
        <translation>Como #1a2b3c; por padrão as usuais, uma depois da outra.</translation>
    </message>
    <message>
        <source>Drag to move the view; the wheel zooms; Escape goes back to Select</source>
        <translation>Arraste para mover a vista; a roda amplia; Escape volta a Selecionar</translation>
    </message>
    <message>
        <source>Drag a box round what is to be seen; a click zooms in, with Shift out; Escape goes back</source>
        <translation>Arraste uma caixa em volta do que se quer ver; um clique aproxima, com Shift afasta; Escape volta</translation>
    </message>
    <message>
        <source>{:.6g} {} in all, area {:.6g} {}²</source>
        <translation>{:.6g} {} no total, área {:.6g} {}²</translation>
    </message>
    <message>
        <source>{:.6g} {}, dip {:.1f}°</source>
        <translation>{:.6g} {}, mergulho {:.1f}°</translation>
    </message>
    <message>
        <source>line {} of the clipboard, '{}', is no pair of numbers x and z</source>
        <translation>a linha {} da área de transferência, '{}', não é um par de números x e z</translation>
    </message>
    <message>
        <source>the clipboard holds no points: a pair of numbers x and z on each line</source>
        <translation>a área de transferência não contém pontos: um par de números x e z em cada linha</translation>
    </message>
    <message>
        <source>{} lines</source>
        <translation>{} linhas</translation>
    </message>
    <message>
        <source>{}: {:.6g} {}, {} vertices</source>
        <translation>{}: {:.6g} {}, {} vértices</translation>
    </message>
    <message>
        <source>dip {:.1f}°</source>
        <translation>mergulho {:.1f}°</translation>
    </message>
    <message>
        <source>A vertical exaggeration is a number from 0.01 to 10000, such as 5</source>
        <translation>O exagero vertical é um número de 0.01 a 10000, como 5</translation>
    </message>
    <message>
        <source>Vertical exaggeration</source>
        <translation>Exagero vertical</translation>
    </message>
    <message>
        <source>Vertical exaggeration of the view; type any number</source>
        <translation>Exagero vertical da vista; digite qualquer número</translation>
    </message>
    <message>
        <source>VE %1</source>
        <translation>EV %1</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Preencher</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vista anterior</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Próxima vista</translation>
    </message>
    <message>
        <source>Zoom to the selection</source>
        <translation>Ampliar a seleção</translation>
    </message>
    <message>
        <source>Fill the canvas</source>
        <translation>Preencher a tela</translation>
    </message>
    <message>
        <source>Other...</source>
        <translation>Outro...</translation>
    </message>
    <message>
        <source>Arrange panels</source>
        <translation>Dispor os painéis</translation>
    </message>
    <message>
        <source>As they are largest</source>
        <translation>Como ficam maiores</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>One above the other</source>
        <translation>Um sobre o outro</translation>
    </message>
    <message>
        <source>Input as a ghost under the result</source>
        <translation>Entrada como fantasma sob o resultado</translation>
    </message>
    <message>
        <source>Panels move together</source>
        <translation>Os painéis movem-se juntos</translation>
    </message>
    <message>
        <source>Units of the axes</source>
        <translation>Unidades dos eixos</translation>
    </message>
    <message>
        <source>Those of the document</source>
        <translation>As do documento</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Kilometres</source>
        <translation>Quilômetros</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pés</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legenda</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Habitual</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Compacta</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhuma</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Renomear...</translation>
    </message>
    <message>
        <source>Kind...</source>
        <translation>Tipo...</translation>
    </message>
    <message>
        <source>Insert vertex here</source>
        <translation>Inserir vértice aqui</translation>
    </message>
    <message>
        <source>Split here</source>
        <translation>Dividir aqui</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>row %1: '%2' is not a number</source>
        <translation>linha %1: '%2' não é um número</translation>
    </message>
    <message>
        <source>row %1 has %2 numbers; copy two columns, x and z</source>
        <translation>a linha %1 tem %2 números; copie duas colunas, x e z</translation>
    </message>
    <message>
        <source>there are no rows of two numbers to paste</source>
        <translation>não há linhas de dois números para colar</translation>
    </message>
    <message>
        <source>'%1' is not a number</source>
        <translation>'%1' não é um número</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Inserir</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Colar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Zoom to it</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Hide its layer</source>
        <translation>Ocultar a camada</translation>
    </message>
    <message>
        <source>Lines copied: %1; Ctrl+V draws them in any window, and a spreadsheet takes them.</source>
        <translation>Linhas copiadas: %1; Ctrl+V as desenha em qualquer janela, e uma planilha as aceita.</translation>
    </message>
    <message>
        <source>Cut lines</source>
        <translation>Recortar linhas</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Mão</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Ampliar uma caixa</translation>
    </message>
    <message>
        <source>Snap to the grid</source>
        <translation>Atrair à grade</translation>
    </message>
    <message>
        <source>This cannot be drawn here: the document has no place for it.</source>
        <translation>Isto não pode ser desenhado aqui: o documento não tem lugar para isso.</translation>
    </message>
    <message>
        <source>Rename '%1'</source>
        <translation>Renomear '%1'</translation>
    </message>
    <message>
        <source>Name and kind</source>
        <translation>Nome e tipo</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Alterar</translation>
    </message>
    <message>
        <source>the document holds no such line</source>
        <translation>o documento não contém essa linha</translation>
    </message>
    <message>
        <source>Cu&amp;t lines</source>
        <translation>Recor&amp;tar linhas</translation>
    </message>
    <message>
        <source>&amp;Copy lines as text</source>
        <translation>&amp;Copiar linhas como texto</translation>
    </message>
    <message>
        <source>&amp;Paste lines</source>
        <translation>Co&amp;lar linhas</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Selecionar &amp;tudo</translation>
    </message>
    <message>
        <source>&amp;Invert the selection</source>
        <translation>&amp;Inverter a seleção</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Digite o que quer fazer</translation>
    </message>
    <message>
        <source>What can be done</source>
        <translation>O que pode ser feito</translation>
    </message>
    <message>
        <source>Cannot be done now</source>
        <translation>Não pode ser feito agora</translation>
    </message>
    <message>
        <source>Add &amp;step</source>
        <translation>Acrescentar &amp;etapa</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Painéis</translation>
    </message>
    <message>
        <source>&amp;Find an action...</source>
        <translation>&amp;Procurar uma ação...</translation>
    </message>
    <message>
        <source>Lists all that can be done, filtered by what you type</source>
        <translation>Lista tudo o que pode ser feito, filtrado pelo que se digita</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>&amp;Teclas...</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Ação</translation>
    </message>
    <message>
        <source>In the menu</source>
        <translation>No menu</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Ir a %1</translation>
    </message>
    <message>
        <source>Hide layer &apos;%1&apos;</source>
        <translation>Ocultar a camada &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Show layer &apos;%1&apos;</source>
        <translation>Mostrar a camada &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message>
        <source>no action &apos;%1&apos;</source>
        <translation>não há ação &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be done now</source>
        <translation>&apos;%1&apos; não pode ser feito agora</translation>
    </message>
    <message>
        <source>Snap to vertices, crossings and lines; not while Alt is held</source>
        <translation>Atrai a vértices, cruzamentos e linhas; não enquanto Alt está pressionada</translation>
    </message>
    <message>
        <source>Cop&amp;y step as scenario text</source>
        <translation>Copiar a etapa como te&amp;xto de cenário</translation>
    </message>
    <message>
        <source>The selected step, or the input, as a scenario writes it, on the clipboard</source>
        <translation>A etapa selecionada, ou a entrada, como um cenário a escreve, na área de transferência</translation>
    </message>
    <message>
        <source>&amp;Paste scenario text as steps</source>
        <translation>&amp;Colar texto de cenário como etapas</translation>
    </message>
    <message>
        <source>Inserts the steps on the clipboard behind the selected one</source>
        <translation>Insere as etapas da área de transferência depois da selecionada</translation>
    </message>
    <message>
        <source>Copy as co&amp;mmand</source>
        <translation>Copiar como co&amp;mando</translation>
    </message>
    <message>
        <source>The command line that does what the window shows, on the clipboard</source>
        <translation>A linha de comando que faz o que a janela mostra, na área de transferência</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Copiado: %1</translation>
    </message>
    <message>
        <source>Paste step</source>
        <translation>Colar etapa</translation>
    </message>
    <message>
        <source>the clipboard holds no step; copy text that begins with [[step]]</source>
        <translation>a área de transferência não contém etapa; copie um texto que comece com [[step]]</translation>
    </message>
    <message>
        <source>the clipboard&apos;s numbers are in other units than those of this document; give both the same unit_system</source>
        <translation>os números da área de transferência estão em outras unidades que os deste documento; dê o mesmo unit_system a ambos</translation>
    </message>
    <message>
        <source>Not all changes of the window are in the file: save it before you run this.</source>
        <translation>Nem todas as alterações da janela estão no arquivo: salve-o antes de executar isto.</translation>
    </message>
    <message>
        <source>-x</source>
        <translation>-x</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>2</source>
        <translation>2</translation>
    </message>
    <message>
        <source>above</source>
        <translation>acima</translation>
    </message>
    <message>
        <source>all</source>
        <translation>todos</translation>
    </message>
    <message>
        <source>allow</source>
        <translation>permitir</translation>
    </message>
    <message>
        <source>along_curve</source>
        <translation>ao longo da curva</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <translation>anti-horário</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arco</translation>
    </message>
    <message>
        <source>as_given</source>
        <translation>como dado</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>b_spline</source>
        <translation>B-spline</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>bed</source>
        <translation>leito</translation>
    </message>
    <message>
        <source>bed</source>
        <comment>kind</comment>
        <translation>base elástica</translation>
    </message>
    <message>
        <source>below</source>
        <translation>abaixo</translation>
    </message>
    <message>
        <source>bevel</source>
        <translation>chanfro</translation>
    </message>
    <message>
        <source>bezier</source>
        <translation>Bézier</translation>
    </message>
    <message>
        <source>bisector</source>
        <translation>bissetriz</translation>
    </message>
    <message>
        <source>blank</source>
        <translation>espaço</translation>
    </message>
    <message>
        <source>body</source>
        <translation>força de volume</translation>
    </message>
    <message>
        <source>both</source>
        <translation>ambos</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>contorno</translation>
    </message>
    <message>
        <source>brazilian_disc</source>
        <translation>disco brasileiro</translation>
    </message>
    <message>
        <source>centre_crack</source>
        <translation>trinca central</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>círculo</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>horário</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>vírgula</translation>
    </message>
    <message>
        <source>compact_tension</source>
        <translation>tração compacta</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>continue</source>
        <translation>continuar</translation>
    </message>
    <message>
        <source>cook</source>
        <translation>membrana de Cook</translation>
    </message>
    <message>
        <source>count</source>
        <translation>contagem</translation>
    </message>
    <message>
        <source>count</source>
        <comment>point_forces</comment>
        <translation>contar</translation>
    </message>
    <message>
        <source>current</source>
        <translation>atual</translation>
    </message>
    <message>
        <source>cut_loops</source>
        <translation>cortar laços</translation>
    </message>
    <message>
        <source>datum</source>
        <translation>datum</translation>
    </message>
    <message>
        <source>delaunay</source>
        <translation>Delaunay</translation>
    </message>
    <message>
        <source>detect</source>
        <translation>detectar</translation>
    </message>
    <message>
        <source>double_cantilever</source>
        <translation>viga dupla em balanço</translation>
    </message>
    <message>
        <source>double_edge_notch</source>
        <translation>entalhe em duas bordas</translation>
    </message>
    <message>
        <source>down</source>
        <translation>para baixo</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>igual</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erro</translation>
    </message>
    <message>
        <source>even</source>
        <translation>uniforme</translation>
    </message>
    <message>
        <source>extended</source>
        <translation>estendido</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>falha</translation>
    </message>
    <message>
        <source>fault_bend_fold</source>
        <translation>dobra por flexão de falha</translation>
    </message>
    <message>
        <source>fault_parallel_flow</source>
        <translation>fluxo paralelo à falha</translation>
    </message>
    <message>
        <source>fault_propagation_fold</source>
        <translation>dobra por propagação de falha</translation>
    </message>
    <message>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <source>file</source>
        <translation>arquivo</translation>
    </message>
    <message>
        <source>first</source>
        <translation>primeira</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>flat</source>
        <comment>caps</comment>
        <translation>reto</translation>
    </message>
    <message>
        <source>flexural</source>
        <translation>flexural</translation>
    </message>
    <message>
        <source>flexural_slip</source>
        <translation>deslizamento flexural</translation>
    </message>
    <message>
        <source>force</source>
        <translation>força</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>direto</translation>
    </message>
    <message>
        <source>front</source>
        <translation>frente</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>full</source>
        <translation>completa</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>crescimento</translation>
    </message>
    <message>
        <source>halving</source>
        <translation>bissecção</translation>
    </message>
    <message>
        <source>hermite</source>
        <translation>Hermite</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>furo</translation>
    </message>
    <message>
        <source>horizons</source>
        <translation>horizontes</translation>
    </message>
    <message>
        <source>in</source>
        <translation>pol</translation>
    </message>
    <message>
        <source>input</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>internal</source>
        <translation>interna</translation>
    </message>
    <message>
        <source>judged</source>
        <translation>julgado</translation>
    </message>
    <message>
        <source>kirsch</source>
        <translation>Kirsch</translation>
    </message>
    <message>
        <source>km</source>
        <translation>km</translation>
    </message>
    <message>
        <source>l_shape</source>
        <translation>forma de L</translation>
    </message>
    <message>
        <source>last</source>
        <translation>última</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>deixar</translation>
    </message>
    <message>
        <source>leave_out</source>
        <translation>deixar fora</translation>
    </message>
    <message>
        <source>left</source>
        <translation>esquerda</translation>
    </message>
    <message>
        <source>left_to_right</source>
        <translation>da esquerda para a direita</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>limitado</translation>
    </message>
    <message>
        <source>line</source>
        <translation>linha</translation>
    </message>
    <message>
        <source>line_length</source>
        <translation>comprimento de linha</translation>
    </message>
    <message>
        <source>longest</source>
        <translation>mais longo</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>map</source>
        <translation>mapa</translation>
    </message>
    <message>
        <source>mitre</source>
        <translation>ponta aguda</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>mais próximo</translation>
    </message>
    <message>
        <source>node</source>
        <translation>nó</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>optimal</source>
        <translation>ótima</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>como no artigo</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>paralelas</translation>
    </message>
    <message>
        <source>plate_with_hole</source>
        <translation>placa com furo</translation>
    </message>
    <message>
        <source>pmma_beam</source>
        <translation>viga de PMMA</translation>
    </message>
    <message>
        <source>points</source>
        <translation>pontos</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polígono</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pressão</translation>
    </message>
    <message>
        <source>proportional</source>
        <translation>proporcional</translation>
    </message>
    <message>
        <source>quarter_plate</source>
        <translation>quarto de placa</translation>
    </message>
    <message>
        <source>rational_bezier</source>
        <translation>Bézier racional</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>recusar</translation>
    </message>
    <message>
        <source>regional</source>
        <translation>regional</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>restaurar</translation>
    </message>
    <message>
        <source>right</source>
        <translation>direita</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>rígido</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>anel</translation>
    </message>
    <message>
        <source>rollover</source>
        <translation>rollover</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>rotação</translation>
    </message>
    <message>
        <source>round</source>
        <translation>arredondado</translation>
    </message>
    <message>
        <source>s_1</source>
        <translation>s_1</translation>
    </message>
    <message>
        <source>s_2</source>
        <translation>s_2</translation>
    </message>
    <message>
        <source>s_xx</source>
        <translation>s_xx</translation>
    </message>
    <message>
        <source>s_xy</source>
        <translation>s_xy</translation>
    </message>
    <message>
        <source>s_yy</source>
        <translation>s_yy</translation>
    </message>
    <message>
        <source>section</source>
        <translation>seção</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>ponto e vírgula</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>cisalhamento</translation>
    </message>
    <message>
        <source>single_edge_notch</source>
        <translation>entalhe em uma borda</translation>
    </message>
    <message>
        <source>spline</source>
        <translation>spline</translation>
    </message>
    <message>
        <source>square</source>
        <translation>quadrado</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>deformação</translation>
    </message>
    <message>
        <source>stress</source>
        <translation>tensão</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabulação</translation>
    </message>
    <message>
        <source>three_point_bend</source>
        <translation>flexão em três pontos</translation>
    </message>
    <message>
        <source>top</source>
        <translation>topo</translation>
    </message>
    <message>
        <source>traction</source>
        <translation>tração</translation>
    </message>
    <message>
        <source>treated</source>
        <translation>tratadas</translation>
    </message>
    <message>
        <source>trimmed</source>
        <translation>aparado</translation>
    </message>
    <message>
        <source>trishear</source>
        <translation>trishear</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>u_x</source>
        <translation>u_x</translation>
    </message>
    <message>
        <source>u_y</source>
        <translation>u_y</translation>
    </message>
    <message>
        <source>untreated</source>
        <translation>não tratadas</translation>
    </message>
    <message>
        <source>up</source>
        <translation>para cima</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>variável</translation>
    </message>
    <message>
        <source>von_mises</source>
        <translation>von Mises</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>paredes</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>T&amp;ela</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como o &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Escuro</translation>
    </message>
    <message>
        <source>As the &amp;theme</source>
        <translation>Como o &amp;tema</translation>
    </message>
    <message>
        <source>&amp;White paper</source>
        <translation>Papel &amp;branco</translation>
    </message>
    <message>
        <source>&amp;Dark canvas</source>
        <translation>Tela es&amp;cura</translation>
    </message>
    <message>
        <source>Places that meet nothing else go to the crossings of the ticks of the axes</source>
        <translation>Lugares que não encontram nada mais vão aos cruzamentos das marcas dos eixos</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 linhas</translation>
    </message>
    <message>
        <source>No line is selected</source>
        <translation>Nenhuma linha está selecionada</translation>
    </message>
    <message>
        <source>Select the rows that are to go.</source>
        <translation>Selecione as linhas que devem sair.</translation>
    </message>
    <message>
        <source>Paste vertices</source>
        <translation>Colar vértices</translation>
    </message>
    <message>
        <source>Point at it on the canvas</source>
        <translation>Apontar no desenho</translation>
    </message>
    <message>
        <source>Has no effect without '%1'.</source>
        <translation>Não tem efeito sem '%1'.</translation>
    </message>
    <message>
        <source>Has no effect with '%1': %2.</source>
        <translation>Não tem efeito com '%1': %2.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sim</translation>
    </message>
    <message>
        <source>no</source>
        <translation>não</translation>
    </message>
    <message>
        <source>Click the line for '%1'; Escape leaves it as it is.</source>
        <translation>Clique na linha para '%1'; Escape deixa como está.</translation>
    </message>
    <message>
        <source>Click the place for '%1'; Escape leaves it as it is.</source>
        <translation>Clique no lugar para '%1'; Escape deixa como está.</translation>
    </message>
    <message>
        <source>This is nothing for '%1': click another line, or press Escape.</source>
        <translation>Isto não serve para '%1': clique em outra linha ou tecle Escape.</translation>
    </message>
    <message>
        <source>(at %1, %2)</source>
        <translation>(em %1; %2)</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Boas-vindas</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Começar</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Novo</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Novo</translation>
    </message>
    <message>
        <source>An empty document</source>
        <translation>Um documento vazio</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Abrir...</translation>
    </message>
    <message>
        <source>A scenario file</source>
        <translation>Um arquivo de cenário</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Arquivos recentes</translation>
    </message>
    <message>
        <source>Examples, opened as copies</source>
        <translation>Exemplos, abertos como cópias</translation>
    </message>
    <message>
        <source>Missing from %1</source>
        <translation>Não está mais em %1</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Redefinir a disposição</translation>
    </message>
    <message>
        <source>Panels, bars and size of the window as at the first start</source>
        <translation>Painéis, barras e tamanho da janela como no primeiro início</translation>
    </message>
    <message>
        <source>&amp;Welcome page</source>
        <translation>Página de &amp;boas-vindas</translation>
    </message>
    <message>
        <source>Examples and recent files</source>
        <translation>Exemplos e arquivos recentes</translation>
    </message>
    <message>
        <source>Fold train</source>
        <translation>Trem de dobras</translation>
    </message>
    <message>
        <source>Five horizons restored to a datum by constant thickness.</source>
        <translation>Cinco horizontes restaurados a um datum com espessura constante.</translation>
    </message>
    <message>
        <source>Flattened and folded again</source>
        <translation>Aplainado e dobrado de novo</translation>
    </message>
    <message>
        <source>A chain of two restorations, there and back.</source>
        <translation>Uma cadeia de duas restaurações, ida e volta.</translation>
    </message>
    <message>
        <source>Two listric faults</source>
        <translation>Duas falhas lístricas</translation>
    </message>
    <message>
        <source>Normal faults undone by vertical shear, the younger first.</source>
        <translation>Falhas normais desfeitas por cisalhamento vertical, a mais nova primeiro.</translation>
    </message>
    <message>
        <source>Thrust with a ramp</source>
        <translation>Empurrão com rampa</translation>
    </message>
    <message>
        <source>A fault-bend fold moved back along its thrust.</source>
        <translation>Uma dobra de flexão de falha movida de volta ao longo do empurrão.</translation>
    </message>
    <message>
        <source>Cosine fold</source>
        <translation>Dobra cosseno</translation>
    </message>
    <message>
        <source>Offset curves of a fold, flattened.</source>
        <translation>Curvas paralelas de uma dobra, aplainadas.</translation>
    </message>
    <message>
        <source>Plate with a hole</source>
        <translation>Placa com furo</translation>
    </message>
    <message>
        <source>A quarter of it, meshed with and without offset curves.</source>
        <translation>Um quarto dela, com malha com e sem curvas paralelas.</translation>
    </message>
    <message>
        <source>Branched crack</source>
        <translation>Trinca ramificada</translation>
    </message>
    <message>
        <source>A crack through two materials, with small elements at its tips.</source>
        <translation>Uma trinca em dois materiais, com elementos pequenos nas pontas.</translation>
    </message>
    <message>
        <source>Edge crack in tension</source>
        <translation>Trinca de borda em tração</translation>
    </message>
    <message>
        <source>Trimmed shell with a crack</source>
        <translation>Casca recortada com uma trinca</translation>
    </message>
    <message>
        <source>A panel of a cylinder with a window, in its chart and in space, and its decks for CalculiX and Nastran.</source>
        <translation>Um painel de um cilindro com uma janela, em sua carta e no espaço, e seus arquivos para CalculiX e Nastran.</translation>
    </message>
    <message>
        <source>Mesh, analysis and stress intensity factors.</source>
        <translation>Malha, análise e fatores de intensidade de tensão.</translation>
    </message>
    <message>
        <source>the lines are to stand in this file, which is there already; save the scenario under another name</source>
        <translation>as linhas devem ficar neste arquivo, que já existe; salve o cenário com outro nome</translation>
    </message>
    <message>
        <source>&amp;Import...</source>
        <translation>&amp;Importar...</translation>
    </message>
    <message>
        <source>Brings lines, drawings or pictures from files into the scenario.</source>
        <translation>Traz linhas, desenhos ou imagens de arquivos para o cenário.</translation>
    </message>
    <message>
        <source>Keep &amp;lines in a file beside</source>
        <translation>Guardar as &amp;linhas em um arquivo ao lado</translation>
    </message>
    <message>
        <source>Saving writes the lines of the scenario to a file of their own, which the scenario names.</source>
        <translation>Salvar escreve as linhas do cenário em um arquivo próprio, que o cenário nomeia.</translation>
    </message>
    <message>
        <source>Import files</source>
        <translation>Importar arquivos</translation>
    </message>
    <message>
        <source>Keep lines in a file beside</source>
        <translation>Guardar as linhas em um arquivo ao lado</translation>
    </message>
    <message>
        <source>Keep lines in the scenario</source>
        <translation>Guardar as linhas no cenário</translation>
    </message>
    <message>
        <source>Lines are saved in %1</source>
        <translation>As linhas são salvas em %1</translation>
    </message>
    <message>
        <source>no file is chosen; tick one</source>
        <translation>nenhum arquivo foi escolhido; marque um</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Import %1 files</source>
        <translation>Importar %1 arquivos</translation>
    </message>
    <message>
        <source>Lines and reading</source>
        <translation>Linhas e leitura</translation>
    </message>
    <message>
        <source>What the lines are</source>
        <translation>O que são as linhas</translation>
    </message>
    <message>
        <source>How the file is read</source>
        <translation>Como o arquivo é lido</translation>
    </message>
    <message>
        <source>What is in the way</source>
        <translation>O que impede</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Import this file</source>
        <translation>Importar este arquivo</translation>
    </message>
    <message>
        <source>Lines of the file</source>
        <translation>Linhas do arquivo</translation>
    </message>
    <message>
        <source>Kind of the selected lines</source>
        <translation>Tipo das linhas selecionadas</translation>
    </message>
    <message>
        <source>Selected lines are</source>
        <translation>As linhas selecionadas são</translation>
    </message>
    <message>
        <source>Pattern of names</source>
        <translation>Padrão de nomes</translation>
    </message>
    <message>
        <source>such as *fault*</source>
        <translation>como *falha*</translation>
    </message>
    <message>
        <source>* stands for any text, ? for one character; capitals count</source>
        <translation>* vale por qualquer texto, ? por um caractere; maiúsculas contam</translation>
    </message>
    <message>
        <source>Kind of the lines that fit the pattern</source>
        <translation>Tipo das linhas que seguem o padrão</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Names like</source>
        <translation>Nomes como</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Padrões</translation>
    </message>
    <message>
        <source>First rows of the file</source>
        <translation>Primeiras linhas de texto do arquivo</translation>
    </message>
    <message>
        <source>Column of x</source>
        <translation>Coluna de x</translation>
    </message>
    <message>
        <source>Column of heights or depths</source>
        <translation>Coluna de alturas ou profundidades</translation>
    </message>
    <message>
        <source>Column of names</source>
        <translation>Coluna de nomes</translation>
    </message>
    <message>
        <source>Columns are separated by</source>
        <translation>As colunas são separadas por</translation>
    </message>
    <message>
        <source>what the file shows</source>
        <translation>o que o arquivo mostra</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>espaços</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>tabulações</translation>
    </message>
    <message>
        <source>commas</source>
        <translation>vírgulas</translation>
    </message>
    <message>
        <source>semicolons</source>
        <translation>ponto e vírgula</translation>
    </message>
    <message>
        <source>Second coordinate</source>
        <translation>Segunda coordenada</translation>
    </message>
    <message>
        <source>as the file says, else a height</source>
        <translation>como diz o arquivo, senão uma altura</translation>
    </message>
    <message>
        <source>height: grows upwards</source>
        <translation>altura: cresce para cima</translation>
    </message>
    <message>
        <source>depth: grows downwards</source>
        <translation>profundidade: cresce para baixo</translation>
    </message>
    <message>
        <source>Unit of the coordinates</source>
        <translation>Unidade das coordenadas</translation>
    </message>
    <message>
        <source>as the file and the scenario say</source>
        <translation>como dizem o arquivo e o cenário</translation>
    </message>
    <message>
        <source>Corners of the picture</source>
        <translation>Cantos da imagem</translation>
    </message>
    <message>
        <source>x and height, lower left; upper right</source>
        <translation>x e altura, inferior esquerdo; superior direito</translation>
    </message>
    <message>
        <source>Read all files like this one</source>
        <translation>Ler todos os arquivos como este</translation>
    </message>
    <message>
        <source>Column of y on the map</source>
        <translation>Coluna de y no mapa</translation>
    </message>
    <message>
        <source>Where x and y are places on the map, the lines are laid into their vertical plane.</source>
        <translation>Quando x e y são lugares no mapa, as linhas são postas em seu plano vertical.</translation>
    </message>
    <message>
        <source>none: x runs along the section</source>
        <translation>nenhuma: x corre ao longo da seção</translation>
    </message>
    <message>
        <source>none, or as the header says</source>
        <translation>nenhuma, ou como diz o cabeçalho</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profundidade</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nome</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 é %2</translation>
    </message>
    <message>
        <source>select lines above</source>
        <translation>selecione linhas acima</translation>
    </message>
    <message>
        <source>No line of this file is called like &apos;%1&apos;.</source>
        <translation>Nenhuma linha deste arquivo se chama como &apos;%1&apos;.</translation>
    </message>
    <message>
        <source>and %1 more remarks</source>
        <translation>e mais %1 observações</translation>
    </message>
    <message>
        <source>%1: choose which of its %2 columns hold x, heights or depths, and names; for places on the map, y too.</source>
        <translation>%1: escolha quais de suas %2 colunas contêm x, alturas ou profundidades e nomes; para lugares no mapa, também y.</translation>
    </message>
    <message>
        <source>Import &apos;%1&apos;</source>
        <translation>Importar &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Prévia do arquivo</translation>
    </message>
    <message>
        <source>%1 to %2 m upwards</source>
        <translation>%1 a %2 m para cima</translation>
    </message>
    <message>
        <source>%1 to %2 m along</source>
        <translation>%1 a %2 m ao longo</translation>
    </message>
    <message>
        <source>heights × %1</source>
        <translation>alturas × %1</translation>
    </message>
    <message>
        <source>Nothing can be shown yet.</source>
        <translation>Ainda não há o que mostrar.</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>(sem nome)</translation>
    </message>
    <message>
        <source>%1 (%2 parts)</source>
        <translation>%1 (%2 partes)</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>o arquivo</translation>
    </message>
    <message>
        <source>guess: its name</source>
        <translation>palpite: o nome</translation>
    </message>
    <message>
        <source>guess: its shape</source>
        <translation>palpite: a forma</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>padrão</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>escolhido</translation>
    </message>
    <message>
        <source>Says who</source>
        <translation>Quem diz</translation>
    </message>
    <message>
        <source>Keep them in a file beside</source>
        <translation>Guardá-las em um arquivo ao lado</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>the scenario</source>
        <translation>o cenário</translation>
    </message>
    <message>
        <source>The lines of %1 are saved in %2 from now on; the file itself stays as it is.</source>
        <translation>As linhas de %1 são salvas em %2 de agora em diante; o próprio arquivo fica como está.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be told from another line by its name; give both the same kind</source>
        <translation>&apos;{}&apos; não se distingue de outra linha pelo nome; dê a ambas o mesmo tipo</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is there already; this one becomes &apos;{}&apos;</source>
        <translation>&apos;{}&apos; já existe; esta passa a ser &apos;{}&apos;</translation>
    </message>
    <message>
        <source>no line is chosen; tick one</source>
        <translation>nenhuma linha foi escolhida; marque uma</translation>
    </message>
    <message>
        <source>this file names materials, points or holes besides its curves, and only one such file can be in a scenario; open it in a scenario of its own</source>
        <translation>este arquivo nomeia materiais, pontos ou furos além das curvas, e um cenário só pode ter um arquivo assim; abra-o em um cenário próprio</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be taken by itself ({}); take all lines of the file, under their names</source>
        <translation>&apos;{}&apos; não pode ser trazida sozinha ({}); traga todas as linhas do arquivo, com seus nomes</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>ela não tem nome</translation>
    </message>
    <message>
        <source>it is in several parts</source>
        <translation>ela está em várias partes</translation>
    </message>
    <message>
        <source>another line has its name</source>
        <translation>outra linha tem o nome dela</translation>
    </message>
    <message>
        <source>the picture does not say where it lies; give its lower left and upper right corner</source>
        <translation>a imagem não diz onde fica; dê o canto inferior esquerdo e o superior direito</translation>
    </message>
    <message>
        <source>a section has one border; choose another kind for the others</source>
        <translation>uma seção tem um só contorno; escolha outro tipo para os demais</translation>
    </message>
    <message>
        <source>a specimen has it by its sizes; change these in the form</source>
        <translation>um corpo de prova a tem por suas medidas; mude-as no formulário</translation>
    </message>
    <message>
        <source>reading has made this; it cannot be edited by itself</source>
        <translation>a leitura fez isto; não pode ser editado sozinho</translation>
    </message>
    <message>
        <source>it is no longer there; run again</source>
        <translation>já não está lá; execute de novo</translation>
    </message>
    <message>
        <source>this is drawn by the program and cannot be edited; edit curves, cracks, points and regions</source>
        <translation>isto é desenhado pelo programa e não pode ser editado; edite curvas, trincas, pontos e regiões</translation>
    </message>
    <message>
        <source>As the drawing shows</source>
        <translation>Como o desenho mostra</translation>
    </message>
    <message>
        <source>Curves of these names are there already: those of the file become curves of the scenario.</source>
        <translation>Já há curvas com estes nomes: as do arquivo tornam-se curvas do cenário.</translation>
    </message>
    <message>
        <source>The scenario has a file already: the curves of this one become curves of the scenario.</source>
        <translation>O cenário já tem um arquivo: as curvas deste tornam-se curvas do cenário.</translation>
    </message>
    <message>
        <source>Growth horizon</source>
        <translation>Horizonte de crescimento</translation>
    </message>
    <message>
        <source>Eroded line</source>
        <translation>Linha erodida</translation>
    </message>
    <message>
        <source>Further names that its sides have in conditions and in the mesh.</source>
        <translation>Outros nomes que seus lados têm nas condições e na malha.</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Conjuntos</translation>
    </message>
    <message>
        <source>What curves of the file are, such as &apos;C*=crack&apos;: outline, hole, internal, crack, found (as the drawing shows), or none to leave them out; the first that fits a name counts.</source>
        <translation>O que são as curvas do arquivo, como &apos;C*=crack&apos;: outline, hole, internal, crack, found (como o desenho mostra) ou none para deixá-las fora; vale o primeiro que serve a um nome.</translation>
    </message>
    <message>
        <source>line: a chain of points; arc: centre and two points; spline: smooth through the points; bezier: cubics end to end, by their vertices.</source>
        <translation>line: uma cadeia de pontos; arc: centro e dois pontos; spline: suave pelos pontos; bezier: cúbicas ponta a ponta, por seus vértices.</translation>
    </message>
    <message>
        <source>line: a chain of points; polygon: closed; arc: centre and two points, or centre, radius, start, sweep; circle: centre and radius; spline: smooth through the points, closed if the last repeats the first; bezier: cubics end to end, by their vertices.</source>
        <translation>line: uma cadeia de pontos; polygon: fechada; arc: centro e dois pontos, ou centro, raio, início e varredura; circle: centro e raio; spline: suave pelos pontos, fechada se o último repete o primeiro; bezier: cúbicas ponta a ponta, por seus vértices.</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>Texto do arquivo</translation>
    </message>
    <message>
        <source>Save and open</source>
        <translation>Salvar e abrir</translation>
    </message>
    <message>
        <source>Nothing is written as long as the text cannot be read</source>
        <translation>Nada é gravado enquanto o texto não puder ser lido</translation>
    </message>
    <message>
        <source>Open another file...</source>
        <translation>Abrir outro arquivo...</translation>
    </message>
    <message>
        <source>Leave the file as it is</source>
        <translation>Deixar o arquivo como está</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 não pode ser lido</translation>
    </message>
    <message>
        <source>Another program has changed the file meanwhile. Save again to replace what it wrote.</source>
        <translation>Outro programa alterou o arquivo nesse meio-tempo. Salve de novo para substituir o que ele gravou.</translation>
    </message>
    <message>
        <source>The text of %1 has changes that are not saved.</source>
        <translation>O texto de %1 tem alterações que não foram salvas.</translation>
    </message>
    <message>
        <source>Nothing that can be done is called so.</source>
        <translation>Nada do que se pode fazer tem esse nome.</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>Importar...</translation>
    </message>
    <message>
        <source>Lines of a text, GeoJSON, DXF or other file</source>
        <translation>Linhas de um arquivo de texto, GeoJSON, DXF ou outro</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>etapa %1</translation>
    </message>
    <message>
        <source>By which surfaces know it.</source>
        <translation>Pelo qual as superfícies a conhecem.</translation>
    </message>
    <message>
        <source>line: a chain of points; arc: through three points; circle: a centre, an axis and angles; bezier: one of any degree, by its vertices; nurbs: control points with knots; spline: smooth through the points.</source>
        <translation>linha: uma cadeia de pontos; arco: por três pontos; circunferência: um centro, um eixo e ângulos; bezier: uma de qualquer grau, por seus vértices; nurbs: pontos de controle com nós; spline: suave pelos pontos.</translation>
    </message>
    <message>
        <source>Points (x, y, z)</source>
        <translation>Pontos (x, y, z)</translation>
    </message>
    <message>
        <source>In order. An arc has three: first, one on the way, last.</source>
        <translation>Em ordem. Um arco tem três: o primeiro, um no caminho e o último.</translation>
    </message>
    <message>
        <source>One a point, greater than 0; all 1 where none are given.</source>
        <translation>Um por ponto, maior que 0; todos 1 onde nenhum é dado.</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Nós</translation>
    </message>
    <message>
        <source>Not decreasing, one for each point and degree + 1 more.</source>
        <translation>Não decrescentes, um para cada ponto e grau + 1 a mais.</translation>
    </message>
    <message>
        <source>Centre (x, y, z)</source>
        <translation>Centro (x, y, z)</translation>
    </message>
    <message>
        <source>Of a circle.</source>
        <translation>De uma circunferência.</translation>
    </message>
    <message>
        <source>Of a circle: it turns anticlockwise about it; z where left out.</source>
        <translation>De uma circunferência: ela gira no sentido anti-horário em torno dele; z onde for omitido.</translation>
    </message>
    <message>
        <source>Direction of angle 0</source>
        <translation>Direção do ângulo 0</translation>
    </message>
    <message>
        <source>Of a circle; square to the axis where left out.</source>
        <translation>De uma circunferência; perpendicular ao eixo onde for omitida.</translation>
    </message>
    <message>
        <source>Of a part of a circle.</source>
        <translation>De uma parte de uma circunferência.</translation>
    </message>
    <message>
        <source>Of a part of a circle; 360 is all of it.</source>
        <translation>De uma parte de uma circunferência; 360 é ela toda.</translation>
    </message>
    <message>
        <source>nurbs</source>
        <translation>nurbs</translation>
    </message>
    <message>
        <source>Of the region of its elements; trims name it.</source>
        <translation>Da região de seus elementos; os recortes o citam.</translation>
    </message>
    <message>
        <source>ruled, extruded, revolved, coons, triangular: of space curves; graph: height by a formula; nurbs: control points with knots; through: smooth through a grid of points.</source>
        <translation>regrada, extrudada, de revolução, coons, triangular: de curvas no espaço; gráfico: altura por uma fórmula; nurbs: pontos de controle com nós; por pontos: suave por uma grade de pontos.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>tool: it is not meshed and only cuts others.</source>
        <translation>ferramenta: não recebe malha e só corta outras.</translation>
    </message>
    <message>
        <source>Names of space curves. ruled: v = 0 and v = 1; extruded, revolved: the profile; coons: bottom, top (both along u), left and right (both along v); triangular: three round it, each either way.</source>
        <translation>Nomes de curvas no espaço. regrada: v = 0 e v = 1; extrudada, de revolução: o perfil; coons: inferior, superior (ambas ao longo de u), esquerda e direita (ambas ao longo de v); triangular: três em volta dela, cada uma em qualquer sentido.</translation>
    </message>
    <message>
        <source>Origin (x, y, z)</source>
        <translation>Origem (x, y, z)</translation>
    </message>
    <message>
        <source>Centre of a sphere or torus, a point of an axis, the point u = v = 0 of a plane.</source>
        <translation>Centro de uma esfera ou toro, um ponto de um eixo, o ponto u = v = 0 de um plano.</translation>
    </message>
    <message>
        <source>Direction of the axis; of a plane its normal. z where left out.</source>
        <translation>Direção do eixo; de um plano, a sua normal. z onde for omitida.</translation>
    </message>
    <message>
        <source>Direction of u = 0</source>
        <translation>Direção de u = 0</translation>
    </message>
    <message>
        <source>Where longitudes begin; of a plane the direction of u. Square to the axis where left out.</source>
        <translation>Onde começam as longitudes; de um plano, a direção de u. Perpendicular ao eixo onde for omitida.</translation>
    </message>
    <message>
        <source>Extruded by (x, y, z)</source>
        <translation>Extrudada por (x, y, z)</translation>
    </message>
    <message>
        <source>Of a cone at v = 0, of a torus from its axis to the middle of its tube.</source>
        <translation>De um cone em v = 0, de um toro do eixo ao meio do tubo.</translation>
    </message>
    <message>
        <source>Radius of the tube</source>
        <translation>Raio do tubo</translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation>Semiângulo</translation>
    </message>
    <message>
        <source>Between the axis of a cone and its sides; negative narrows it along the axis.</source>
        <translation>Entre o eixo de um cone e seus lados; negativo o estreita ao longo do eixo.</translation>
    </message>
    <message>
        <source>Range of u</source>
        <translation>Intervalo de u</translation>
    </message>
    <message>
        <source>From, to. Longitudes in degrees (all round where left out); of a plane and a graph lengths.</source>
        <translation>De, até. Longitudes em graus (a volta toda onde for omitido); de um plano e de um gráfico, comprimentos.</translation>
    </message>
    <message>
        <source>Range of v</source>
        <translation>Intervalo de v</translation>
    </message>
    <message>
        <source>From, to. Latitudes in degrees (pole to pole where left out), angles round the tube of a torus; else lengths, along the axis or, of a cone, along its side.</source>
        <translation>De, até. Latitudes em graus (de polo a polo onde for omitido), ângulos em torno do tubo de um toro; senão comprimentos, ao longo do eixo ou, de um cone, ao longo do lado.</translation>
    </message>
    <message>
        <source>Height z</source>
        <translation>Altura z</translation>
    </message>
    <message>
        <source>A formula of x and y.</source>
        <translation>Uma fórmula de x e y.</translation>
    </message>
    <message>
        <source>Both ways.</source>
        <translation>Nos dois sentidos.</translation>
    </message>
    <message>
        <source>Degree along u</source>
        <translation>Grau ao longo de u</translation>
    </message>
    <message>
        <source>Degree along v</source>
        <translation>Grau ao longo de v</translation>
    </message>
    <message>
        <source>Knots along u</source>
        <translation>Nós ao longo de u</translation>
    </message>
    <message>
        <source>Not decreasing, one for each row and degree + 1 more.</source>
        <translation>Não decrescentes, um para cada linha e grau + 1 a mais.</translation>
    </message>
    <message>
        <source>Knots along v</source>
        <translation>Nós ao longo de v</translation>
    </message>
    <message>
        <source>Not decreasing, one for each column and degree + 1 more.</source>
        <translation>Não decrescentes, um para cada coluna e grau + 1 a mais.</translation>
    </message>
    <message>
        <source>A grid, row after row: along v first, then along u.</source>
        <translation>Uma grade, linha após linha: primeiro ao longo de v, depois de u.</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Linhas</translation>
    </message>
    <message>
        <source>Of the grid, along u.</source>
        <translation>Da grade, ao longo de u.</translation>
    </message>
    <message>
        <source>Triangles face</source>
        <translation>Triângulos voltados</translation>
    </message>
    <message>
        <source>Along the normal Su x Sv of the surface, or against it.</source>
        <translation>No sentido da normal Su x Sv da superfície, ou contra ela.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>ruled</source>
        <translation>regrada</translation>
    </message>
    <message>
        <source>extruded</source>
        <translation>extrudada</translation>
    </message>
    <message>
        <source>revolved</source>
        <translation>de revolução</translation>
    </message>
    <message>
        <source>coons</source>
        <translation>coons</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>triangular</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>esfera</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cilindro</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>cone</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>toro</translation>
    </message>
    <message>
        <source>graph</source>
        <translation>gráfico</translation>
    </message>
    <message>
        <source>through</source>
        <translation>por pontos</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>malha</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>ferramenta</translation>
    </message>
    <message>
        <source>along</source>
        <translation>no sentido</translation>
    </message>
    <message>
        <source>against</source>
        <translation>contra</translation>
    </message>
    <message>
        <source>Of the set of its sides; a crack NAME has the lips NAME_left and NAME_right and the ends NAME_start and NAME_end.</source>
        <translation>Do conjunto de seus lados; uma trinca NOME tem os lábios NOME_left e NOME_right e as pontas NOME_start e NOME_end.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superfície</translation>
    </message>
    <message>
        <source>On which it lies; may be left out where one is meshed.</source>
        <translation>Sobre a qual está; pode ser omitida onde uma só recebe malha.</translation>
    </message>
    <message>
        <source>In the chart: line (a chain), polygon, circle, ellipse, arc (three points), spline, bezier (one of any degree). In space: where another surface or a plane cuts it.</source>
        <translation>Na carta: linha (uma cadeia), polígono, circunferência, elipse, arco (três pontos), spline, bezier (uma de qualquer grau). No espaço: onde outra superfície ou um plano a corta.</translation>
    </message>
    <message>
        <source>hole: what lies inside is taken away; outline: what lies outside; cut: divides, and parts say what stays; internal: sides of the mesh lie along it; interface: between two regions; crack: the mesh is opened along it.</source>
        <translation>furo: o que está dentro é retirado; contorno: o que está fora; corte: divide, e as partes dizem o que fica; interna: lados da malha ficam ao longo dela; interface: entre duas regiões; trinca: a malha é aberta ao longo dela.</translation>
    </message>
    <message>
        <source>Points (u, v)</source>
        <translation>Pontos (u, v)</translation>
    </message>
    <message>
        <source>Of the chart. An arc has three: first, one on the way, last.</source>
        <translation>Da carta. Um arco tem três: o primeiro, um no caminho e o último.</translation>
    </message>
    <message>
        <source>Centre (u, v)</source>
        <translation>Centro (u, v)</translation>
    </message>
    <message>
        <source>Of the chart.</source>
        <translation>Da carta.</translation>
    </message>
    <message>
        <source>In the numbers of the chart.</source>
        <translation>Nos números da carta.</translation>
    </message>
    <message>
        <source>Half axes</source>
        <translation>Semieixos</translation>
    </message>
    <message>
        <source>Two, in the numbers of the chart.</source>
        <translation>Dois, nos números da carta.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>Of the first half axis from u.</source>
        <translation>Do primeiro semieixo a partir de u.</translation>
    </message>
    <message>
        <source>Cut by</source>
        <translation>Cortada por</translation>
    </message>
    <message>
        <source>Name of the other surface.</source>
        <translation>Nome da outra superfície.</translation>
    </message>
    <message>
        <source>Point of the plane (x, y, z)</source>
        <translation>Ponto do plano (x, y, z)</translation>
    </message>
    <message>
        <source>Normal of the plane</source>
        <translation>Normal do plano</translation>
    </message>
    <message>
        <source>Distances of bands</source>
        <translation>Distâncias das faixas</translation>
    </message>
    <message>
        <source>Of lines round a crack, along which the mesh has sides: lengths in space from the crack.</source>
        <translation>De linhas em torno de uma trinca, ao longo das quais a malha tem lados: comprimentos no espaço a partir da trinca.</translation>
    </message>
    <message>
        <source>Radius of rosettes</source>
        <translation>Raio das rosetas</translation>
    </message>
    <message>
        <source>Of a ring of triangles round each end of a crack inside, a length in space; the size of elements there unless another is given; 0: no ring.</source>
        <translation>De um anel de triângulos em torno de cada ponta interna de uma trinca, um comprimento no espaço; o tamanho dos elementos ali, se outro não é dado; 0: nenhum anel.</translation>
    </message>
    <message>
        <source>Of a rosette.</source>
        <translation>De uma roseta.</translation>
    </message>
    <message>
        <source>Length of the element sides at both ends of a crack; 0: none of their own.</source>
        <translation>Comprimento dos lados dos elementos nas duas pontas de uma trinca; 0: nenhum próprio.</translation>
    </message>
    <message>
        <source>May be left out where one is meshed.</source>
        <translation>Pode ser omitida onde uma só recebe malha.</translation>
    </message>
    <message>
        <source>It</source>
        <translation>Ela</translation>
    </message>
    <message>
        <source>keep: once a part of a surface is kept, those that are not named are dropped.</source>
        <translation>manter: desde que uma parte de uma superfície seja mantida, as que não são citadas são descartadas.</translation>
    </message>
    <message>
        <source>Place (u, v)</source>
        <translation>Lugar (u, v)</translation>
    </message>
    <message>
        <source>Anywhere in the part, in the chart; or:</source>
        <translation>Em qualquer lugar da parte, na carta; ou:</translation>
    </message>
    <message>
        <source>Place (x, y, z)</source>
        <translation>Lugar (x, y, z)</translation>
    </message>
    <message>
        <source>Anywhere in the part, in space; the nearest point counts.</source>
        <translation>Em qualquer lugar da parte, no espaço; vale o ponto mais próximo.</translation>
    </message>
    <message>
        <source>Name of its elements' region.</source>
        <translation>Nome da região de seus elementos.</translation>
    </message>
    <message>
        <source>In the chart; or:</source>
        <translation>Na carta; ou:</translation>
    </message>
    <message>
        <source>In space; the nearest point of the surface counts.</source>
        <translation>No espaço; vale o ponto mais próximo da superfície.</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>elipse</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>superfície</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>contorno</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>corte</translation>
    </message>
    <message>
        <source>interface</source>
        <translation>interface</translation>
    </message>
    <message>
        <source>crack</source>
        <translation>trinca</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>manter</translation>
    </message>
    <message>
        <source>drop</source>
        <translation>descartar</translation>
    </message>
    <message>
        <source>Curves in space</source>
        <translation>Curvas no espaço</translation>
    </message>
    <message>
        <source>Borders and profiles of surfaces.</source>
        <translation>Bordas e perfis de superfícies.</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Superfícies</translation>
    </message>
    <message>
        <source>Meshed as shells; borders that coincide are one.</source>
        <translation>Recebem malha como cascas; bordas que coincidem são uma só.</translation>
    </message>
    <message>
        <source>Trims of surfaces</source>
        <translation>Recortes de superfícies</translation>
    </message>
    <message>
        <source>Holes, outlines, lines inside and cracks, drawn in the chart or cut by others.</source>
        <translation>Furos, contornos, linhas internas e trincas, desenhados na carta ou cortados por outras.</translation>
    </message>
    <message>
        <source>Parts of surfaces</source>
        <translation>Partes de superfícies</translation>
    </message>
    <message>
        <source>That trims divide: which stay, and their regions.</source>
        <translation>Que os recortes dividem: quais ficam, e suas regiões.</translation>
    </message>
    <message>
        <source>Points of surfaces</source>
        <translation>Pontos de superfícies</translation>
    </message>
    <message>
        <source>Nodes with a name.</source>
        <translation>Nós com nome.</translation>
    </message>
    <message>
        <source>A surface or a part with a name; empty: all that have no material of their own.</source>
        <translation>Uma superfície ou uma parte com nome; vazio: todas as que não têm material próprio.</translation>
    </message>
    <message>
        <source>The surface is its middle.</source>
        <translation>A superfície é o seu meio.</translation>
    </message>
    <message>
        <source>A set of sides or nodes: a trim, a point, a side of a chart NAME_left, NAME_right, NAME_bottom, NAME_top.</source>
        <translation>Um conjunto de lados ou nós: um recorte, um ponto, um lado de uma carta NOME_left, NOME_right, NOME_bottom, NOME_top.</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>Ao longo de z</translation>
    </message>
    <message>
        <source>About x</source>
        <translation>Em torno de x</translation>
    </message>
    <message>
        <source>Prescribed rotation; 0 holds, nothing leaves free.</source>
        <translation>Rotação prescrita; 0 segura, nada deixa livre.</translation>
    </message>
    <message>
        <source>About y</source>
        <translation>Em torno de y</translation>
    </message>
    <message>
        <source>About z</source>
        <translation>Em torno de z</translation>
    </message>
    <message>
        <source>A region (area, pressure, body; empty: all), a set of sides (edge), a set of nodes (force).</source>
        <translation>Uma região (área, pressão, volume; vazio: todas), um conjunto de lados (aresta), um conjunto de nós (força).</translation>
    </message>
    <message>
        <source>area: x, y, z on each unit of the surface; pressure: value, against the normal of the elements; body: x, y, z on each unit of volume, such as the weight; edge: x, y, z on each unit of length; force: x, y, z at each node.</source>
        <translation>área: x, y, z em cada unidade da superfície; pressão: valor, contra a normal dos elementos; volume: x, y, z em cada unidade de volume, como o peso; aresta: x, y, z em cada unidade de comprimento; força: x, y, z em cada nó.</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>area</source>
        <translation>área</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>aresta</translation>
    </message>
    <message>
        <source>That one element side on an arc may span; of a surface, that its normal may turn along a side.</source>
        <translation>Que um lado de elemento sobre um arco pode abranger; de uma superfície, que a sua normal pode girar ao longo de um lado.</translation>
    </message>
    <message>
        <source>Greatest distance from a surface</source>
        <translation>Maior distância a uma superfície</translation>
    </message>
    <message>
        <source>Of the elements' sides; 0 does not ask. Of surfaces in space only.</source>
        <translation>Dos lados dos elementos; 0 não pede. Só de superfícies no espaço.</translation>
    </message>
    <message>
        <source>What places the nodes inside: rows from the boundary inwards; one by one in a Delaunay triangulation, which is slower (plane domains only); or the front of [miranda2009surface] as it is written.</source>
        <translation>O que coloca os nós internos: fileiras do contorno para dentro; um a um numa triangulação de Delaunay, mais lenta (só domínios planos); ou a frente de [miranda2009surface], como está escrita.</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Casca</translation>
    </message>
    <message>
        <source>Thickness, materials, supports and loads of a mesh of surfaces: decks for other programs.</source>
        <translation>Espessura, materiais, apoios e cargas de uma malha de superfícies: arquivos para outros programas.</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Carta</translation>
    </message>
    <message>
        <source>u (length) [m]</source>
        <translation>u (comprimento) [m]</translation>
    </message>
    <message>
        <source>v (length) [m]</source>
        <translation>v (comprimento) [m]</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>N/m</translation>
    </message>
    <message>
        <source>Picture in space</source>
        <translation>Figura no espaço</translation>
    </message>
    <message>
        <source>Arrow keys turn, with Shift they move; + and - zoom, F shows all, 1 to 8 look from the usual sides.</source>
        <translation>As setas giram, com Shift deslocam; + e - aproximam e afastam, F mostra tudo, de 1 a 8 olham dos lados usuais.</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>No espaço</translation>
    </message>
    <message>
        <source>View in &amp;space</source>
        <translation>Vista no e&amp;spaço</translation>
    </message>
    <message>
        <source>Beside the plane</source>
        <translation>Ao lado do plano</translation>
    </message>
    <message>
        <source>The plane alone</source>
        <translation>Só o plano</translation>
    </message>
    <message>
        <source>Space alone</source>
        <translation>Só o espaço</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>De &amp;frente</translation>
    </message>
    <message>
        <source>From the &amp;top</source>
        <translation>De &amp;cima</translation>
    </message>
    <message>
        <source>From the &amp;right</source>
        <translation>Da &amp;direita</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrica</translation>
    </message>
    <message>
        <source>&amp;Dimetric</source>
        <translation>Di&amp;métrica</translation>
    </message>
    <message>
        <source>&amp;Cavalier</source>
        <translation>Ca&amp;valeira</translation>
    </message>
    <message>
        <source>Ca&amp;binet</source>
        <translation>Ga&amp;binete</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspectiva</translation>
    </message>
    <message>
        <source>Fit the view in space</source>
        <translation>Ajustar a vista no espaço</translation>
    </message>
    <message>
        <source>&amp;Save the picture in space...</source>
        <translation>&amp;Salvar a figura no espaço...</translation>
    </message>
    <message>
        <source>Save the picture in space</source>
        <translation>Salvar a figura no espaço</translation>
    </message>
    <message>
        <source>there is no picture in space; run a scenario that has one</source>
        <translation>não há figura no espaço; execute um cenário que tenha uma</translation>
    </message>
    <message>
        <source>Of x and y: "0.1 + 0.05 * hypot(x, y)"; the least of all sizes counts. On surfaces of x, y, z and, where one is meshed, of the u and v of its chart.</source>
        <translation>De x e y: "0.1 + 0.05 * hypot(x, y)"; vale o menor de todos os tamanhos. Em superfícies, de x, y, z e, onde uma só recebe malha, de u e v da sua carta.</translation>
    </message>
    <message>
        <source>Most by which sizes may grow from one element to the next; left out: 1.3 in the plane, 1.17 on surfaces.</source>
        <translation>O máximo que os tamanhos podem crescer de um elemento ao seguinte; omitido: 1,3 no plano, 1,17 em superfícies.</translation>
    </message>
    <message>
        <source>What places the nodes inside: rows from the boundary inwards; one by one in a Delaunay triangulation, which is slower (plane domains only); or the front of the paper on surfaces, as it is written.</source>
        <translation>O que coloca os nós internos: fileiras do contorno para dentro; um a um numa triangulação de Delaunay, mais lenta (só domínios planos); ou a frente do artigo sobre superfícies, como está escrita.</translation>
    </message>
    <message>
        <source>Boundary model</source>
        <translation>Modelo de fronteira</translation>
    </message>
    <message>
        <source>Geometry as a drawing or as lines, a mesh whose boundary is meant, or faces of a boundary model.</source>
        <translation>Geometria como desenho ou como linhas, uma malha cujo contorno é o que se quer, ou faces de um modelo de fronteira.</translation>
    </message>
    <message>
        <source>View in space</source>
        <translation>Vista no espaço</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Cores</translation>
    </message>
    <message>
        <source>Surfaces have the colours of their values; the legend says which</source>
        <translation>As superfícies têm as cores de seus valores; a legenda diz quais</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>A plane cuts the picture, to look inside; what is before it is not shown</source>
        <translation>Um plano corta a figura, para olhar para dentro; o que está diante dele não é mostrado</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Plano de corte</translation>
    </message>
    <message>
        <source>What the section plane is square to: an axis, or a direction once its rim is dragged</source>
        <translation>A que o plano de corte é perpendicular: um eixo, ou uma direção depois que sua borda é arrastada</translation>
    </message>
    <message>
        <source>Place of the section plane, a number</source>
        <translation>Posição do plano de corte, um número</translation>
    </message>
    <message>
        <source>Where the plane stands on the axis; turned, how far from the origin along its normal</source>
        <translation>Onde o plano fica no eixo; se girado, a distância à origem ao longo de sua normal</translation>
    </message>
    <message>
        <source>The section plane stands from %1 to %2.</source>
        <translation>O plano de corte fica entre %1 e %2.</translation>
    </message>
    <message>
        <source>Drag the arrow to move the section plane, its rim to turn it; Escape takes a drag back.</source>
        <translation>Arraste a seta para mover o plano de corte, sua borda para girá-lo; Esc desfaz o arraste.</translation>
    </message>
    <message>
        <source>Drag the arrow: the section plane moves along its normal</source>
        <translation>Arraste a seta: o plano de corte se move ao longo de sua normal</translation>
    </message>
    <message>
        <source>Drag the rim: the section plane turns about its middle</source>
        <translation>Arraste a borda: o plano de corte gira em torno de seu meio</translation>
    </message>
    <message>
        <source>Place of the section plane</source>
        <translation>Lugar do plano de corte</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Outro lado</translation>
    </message>
    <message>
        <source>Takes away what lies on the other side of the plane</source>
        <translation>Retira o que está do outro lado do plano</translation>
    </message>
    <message>
        <source>Choose parts</source>
        <translation>Escolher partes</translation>
    </message>
    <message>
        <source>Leaves parts of surfaces out of the mesh, or takes them in, by clicks in the chart and in space</source>
        <translation>Deixa partes de superfícies fora da malha, ou as inclui, por cliques na carta e no espaço</translation>
    </message>
    <message>
        <source>Click a part of a surface, in its chart or in space, to leave it out or to take it in again</source>
        <translation>Clique em uma parte de uma superfície, na carta ou no espaço, para deixá-la de fora ou incluí-la de novo</translation>
    </message>
    <message>
        <source>There are no surfaces here</source>
        <translation>Não há superfícies aqui</translation>
    </message>
    <message>
        <source>click inside a part, away from the lines that bound it</source>
        <translation>clique dentro de uma parte, longe das linhas que a limitam</translation>
    </message>
    <message>
        <source>Take in a part of &apos;%1&apos;</source>
        <translation>Incluir uma parte de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Leave out a part of &apos;%1&apos;</source>
        <translation>Deixar de fora uma parte de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Move point %1 of &apos;%2&apos;</source>
        <translation>Mover o ponto %1 de &apos;%2&apos;</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normais</translation>
    </message>
    <message>
        <source>Which way the triangles face</source>
        <translation>Para que lado os triângulos olham</translation>
    </message>
    <message>
        <source>u, v lines</source>
        <translation>Linhas u, v</translation>
    </message>
    <message>
        <source>Lines of constant u and v</source>
        <translation>Linhas de u e v constantes</translation>
    </message>
    <message>
        <source>(at %1, %2, %3)</source>
        <translation>(em %1; %2; %3)</translation>
    </message>
    <message>
        <source>(u = %1, v = %2)</source>
        <translation>(u = %1; v = %2)</translation>
    </message>
    <message>
        <source>{:.6g} {}, angle {:.1f}°</source>
        <translation>{:.6g} {}, ângulo {:.1f}°</translation>
    </message>
    <message>
        <source>angle {:.1f}°</source>
        <translation>ângulo {:.1f}°</translation>
    </message>
    <message>
        <source>Shells apart</source>
        <translation>Cascas separadas</translation>
    </message>
    <message>
        <source>Draws the shells of a solid away from each other</source>
        <translation>Desenha as cascas de um sólido afastadas umas das outras</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arestas</translation>
    </message>
    <message>
        <source>Faces that are cut</source>
        <translation>Faces cortadas</translation>
    </message>
    <message>
        <source>Mine pillar of solids</source>
        <translation>Pilar de mina em sólidos</translation>
    </message>
    <message>
        <source>Blocks, a dyke and bores, combined step by step; its section is meshed and analysed.</source>
        <translation>Blocos, um dique e furos, combinados passo a passo; a seção é malhada e analisada.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constatações</translation>
    </message>
    <message>
        <source>along the section</source>
        <translation>ao longo do corte</translation>
    </message>
    <message>
        <source>up the section</source>
        <translation>corte acima</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>Pontos de controle</translation>
    </message>
    <message>
        <source>Control polygons</source>
        <translation>Polígonos de controle</translation>
    </message>
    <message>
        <source>The points that curves and surfaces are given by; drag them</source>
        <translation>Os pontos que definem curvas e superfícies; arraste-os</translation>
    </message>
    <message>
        <source>Parts left out</source>
        <translation>Partes deixadas de fora</translation>
    </message>
    <message>
        <source>faces of a file are meshed as they are; cracks are of surfaces that a scenario describes</source>
        <translation>faces de um arquivo são malhadas como estão; trincas são de superfícies que um cenário descreve</translation>
    </message>
    <message>
        <source>this document is of surfaces, whose lines are trims: draw cracks with the crack tool, others in the form</source>
        <translation>este documento é de superfícies, cujas linhas são recortes: desenhe trincas com a ferramenta de trincas, as outras no formulário</translation>
    </message>
    <message>
        <source>faces of a file are meshed whole; parts are of surfaces that a scenario describes</source>
        <translation>faces de um arquivo são malhadas inteiras; partes são de superfícies que um cenário descreve</translation>
    </message>
    <message>
        <source>this is a hole, or lies outside the outlines; their trims say so</source>
        <translation>isto é um furo, ou está fora dos contornos; os seus cortes dizem isso</translation>
    </message>
    <message>
        <source>this is the only part that is left; take another one in first</source>
        <translation>esta é a única parte que resta; inclua outra antes</translation>
    </message>
    <message>
        <source>it has no such point any more</source>
        <translation>ele já não tem esse ponto</translation>
    </message>
    <message>
        <source>Charts are those of the first {} of {} surfaces.</source>
        <translation>As cartas são as das primeiras {} de {} superfícies.</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Sólidos</translation>
    </message>
    <message>
        <source>The steps make solids: there is no plane domain before the step `cut` makes one of them.</source>
        <translation>As etapas fazem sólidos: não há domínio plano antes que a etapa `cut` faça um deles.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Bloco</translation>
    </message>
    <message>
        <source>A box by its three sizes.</source>
        <translation>Uma caixa por seus três tamanhos.</translation>
    </message>
    <message>
        <source>Prism</source>
        <translation>Prisma</translation>
    </message>
    <message>
        <source>Over a regular polygon.</source>
        <translation>Sobre um polígono regular.</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pirâmide</translation>
    </message>
    <message>
        <source>Over a regular polygon, to a point.</source>
        <translation>Sobre um polígono regular, até um ponto.</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cilindro</translation>
    </message>
    <message>
        <source>Over a polygon that stands for a circle.</source>
        <translation>Sobre um polígono que representa um círculo.</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cone</translation>
    </message>
    <message>
        <source>Over a polygon that stands for a circle, to a point or a smaller circle.</source>
        <translation>Sobre um polígono que representa um círculo, até um ponto ou um círculo menor.</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>About its origin, with corners on the sphere.</source>
        <translation>Em torno de sua origem, com vértices na esfera.</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Toro</translation>
    </message>
    <message>
        <source>A ring about its z axis.</source>
        <translation>Um anel em torno de seu eixo z.</translation>
    </message>
    <message>
        <source>Extruded profile</source>
        <translation>Perfil extrudado</translation>
    </message>
    <message>
        <source>A plane contour with holes, moved along a vector.</source>
        <translation>Um contorno plano com furos, movido ao longo de um vetor.</translation>
    </message>
    <message>
        <source>Profile along a path</source>
        <translation>Perfil ao longo de um caminho</translation>
    </message>
    <message>
        <source>A plane contour with holes, moved along straight legs with mitred corners.</source>
        <translation>Um contorno plano com furos, movido por trechos retos com cantos em meia-esquadria.</translation>
    </message>
    <message>
        <source>Corners of a closed contour; the first is joined to the first of the next profile.</source>
        <translation>Vértices de um contorno fechado; o primeiro é unido ao primeiro do perfil seguinte.</translation>
    </message>
    <message>
        <source>Direction in which its plane looks; z where left out.</source>
        <translation>Direção para a qual seu plano está voltado; z se omitida.</translation>
    </message>
    <message>
        <source>Two or more, each in front of the one before.</source>
        <translation>Dois ou mais, cada um à frente do anterior.</translation>
    </message>
    <message>
        <source>Profiles joined</source>
        <translation>Perfis unidos</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Perfis</translation>
    </message>
    <message>
        <source>Plane contours in space, each joined to the next by triangles.</source>
        <translation>Contornos planos no espaço, cada um unido ao seguinte por triângulos.</translation>
    </message>
    <message>
        <source>Turned profile</source>
        <translation>Perfil de revolução</translation>
    </message>
    <message>
        <source>A contour of (radius, z) turned about the z axis, all the way round or part of it.</source>
        <translation>Um contorno de (raio, z) girado em torno do eixo z, por inteiro ou em parte.</translation>
    </message>
    <message>
        <source>Solid of a file</source>
        <translation>Sólido de um arquivo</translation>
    </message>
    <message>
        <source>A solid whose boundary a file holds.</source>
        <translation>Um sólido cuja fronteira está em um arquivo.</translation>
    </message>
    <message>
        <source>United parts</source>
        <translation>Peças unidas</translation>
    </message>
    <message>
        <source>What is in any of the parts, as one body.</source>
        <translation>O que está em alguma das peças, como um só corpo.</translation>
    </message>
    <message>
        <source>Common part</source>
        <translation>Parte comum</translation>
    </message>
    <message>
        <source>What of the first part is in all the others.</source>
        <translation>O que da primeira peça está em todas as outras.</translation>
    </message>
    <message>
        <source>Part without others</source>
        <translation>Peça sem as outras</translation>
    </message>
    <message>
        <source>What of the first part is in none of the others.</source>
        <translation>O que da primeira peça não está em nenhuma das outras.</translation>
    </message>
    <message>
        <source>Group of parts</source>
        <translation>Grupo de peças</translation>
    </message>
    <message>
        <source>Parts side by side, each with its material; it is placed and cut as one.</source>
        <translation>Peças lado a lado, cada uma com seu material; o grupo é posicionado e cortado como uma só.</translation>
    </message>
    <message>
        <source>Placed part</source>
        <translation>Peça posicionada</translation>
    </message>
    <message>
        <source>Parts scaled, turned and moved, or placed by a matrix; those they are made of stay.</source>
        <translation>Peças escaladas, giradas e movidas, ou posicionadas por uma matriz; aquelas de que são feitas ficam.</translation>
    </message>
    <message>
        <source>Rounded part</source>
        <translation>Peça arredondada</translation>
    </message>
    <message>
        <source>All edges and corners of a convex part rounded.</source>
        <translation>Todas as arestas e vértices de uma peça convexa arredondados.</translation>
    </message>
    <message>
        <source>Section by a plane</source>
        <translation>Seção por um plano</translation>
    </message>
    <message>
        <source>The section of parts becomes the plane domain: outlines, holes and materials.</source>
        <translation>A seção das peças torna-se o domínio plano: contornos, furos e materiais.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Peça</translation>
    </message>
    <message>
        <source>What the result is called; later steps name it in `of`, and its faces begin with it.</source>
        <translation>Como o resultado se chama; etapas posteriores o citam em `of`, e suas faces começam com ele.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Region of the domains that are cut from it; empty: the name of the part.</source>
        <translation>Região dos domínios cortados dela; vazio: o nome da peça.</translation>
    </message>
    <message>
        <source>At (x, y, z)</source>
        <translation>Em (x, y, z)</translation>
    </message>
    <message>
        <source>Where its origin is put.</source>
        <translation>Onde fica sua origem.</translation>
    </message>
    <message>
        <source>Direction in which its z axis is turned; z where left out.</source>
        <translation>Direção para a qual seu eixo z é girado; z se omitido.</translation>
    </message>
    <message>
        <source>Size (x, y, z)</source>
        <translation>Tamanho (x, y, z)</translation>
    </message>
    <message>
        <source>From its origin, which is a corner; each above 0.</source>
        <translation>A partir de sua origem, que é um vértice; cada um maior que 0.</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>Of its base.</source>
        <translation>De sua base.</translation>
    </message>
    <message>
        <source>From the middle of its base to a corner.</source>
        <translation>Do meio de sua base até um vértice.</translation>
    </message>
    <message>
        <source>Corners of the polygon that stands for a circle, all of them on it.</source>
        <translation>Vértices do polígono que representa um círculo, todos sobre ele.</translation>
    </message>
    <message>
        <source>Radius at the top</source>
        <translation>Raio no topo</translation>
    </message>
    <message>
        <source>0 makes a point.</source>
        <translation>0 faz um ponto.</translation>
    </message>
    <message>
        <source>From pole to pole.</source>
        <translation>De polo a polo.</translation>
    </message>
    <message>
        <source>Below the radius.</source>
        <translation>Menor que o raio.</translation>
    </message>
    <message>
        <source>Corners round the tube.</source>
        <translation>Vértices em volta do tubo.</translation>
    </message>
    <message>
        <source>Corners of a closed contour.</source>
        <translation>Vértices de um contorno fechado.</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Furos</translation>
    </message>
    <message>
        <source>Of the profile.</source>
        <translation>Do perfil.</translation>
    </message>
    <message>
        <source>By (x, y, z)</source>
        <translation>Por (x, y, z)</translation>
    </message>
    <message>
        <source>How far the profile, which lies in z = 0, is moved.</source>
        <translation>Quanto o perfil, que está em z = 0, é movido.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Caminho</translation>
    </message>
    <message>
        <source>Points in space that the profile&apos;s origin moves along; corners are mitred.</source>
        <translation>Pontos no espaço por onde a origem do perfil se move; os cantos são em meia-esquadria.</translation>
    </message>
    <message>
        <source>Corners of a closed contour of (radius, z); sides on the axis make no faces.</source>
        <translation>Vértices de um contorno fechado de (raio, z); lados no eixo não fazem faces.</translation>
    </message>
    <message>
        <source>In degrees about the z axis, anticlockwise from x.</source>
        <translation>Em graus em torno do eixo z, anti-horário a partir de x.</translation>
    </message>
    <message>
        <source>Over the whole angle.</source>
        <translation>Em todo o ângulo.</translation>
    </message>
    <message>
        <source>The boundary of a solid.</source>
        <translation>A fronteira de um sólido.</translation>
    </message>
    <message>
        <source>Boundaries of solids</source>
        <translation>Fronteiras de sólidos</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Names of parts that steps before have made; a part may be used more than once.</source>
        <translation>Nomes de peças que etapas anteriores fizeram; uma peça pode ser usada mais de uma vez.</translation>
    </message>
    <message>
        <source>Scale (x, y, z)</source>
        <translation>Escala (x, y, z)</translation>
    </message>
    <message>
        <source>Factors about the point `about`, first; negative ones mirror.</source>
        <translation>Fatores em torno do ponto `about`, primeiro; negativos espelham.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>In degrees, anticlockwise about an axis through the point `about`, second.</source>
        <translation>Em graus, anti-horário em torno de um eixo pelo ponto `about`, depois.</translation>
    </message>
    <message>
        <source>Axis of the turn</source>
        <translation>Eixo do giro</translation>
    </message>
    <message>
        <source>z where left out.</source>
        <translation>z se omitido.</translation>
    </message>
    <message>
        <source>About (x, y, z)</source>
        <translation>Em torno de (x, y, z)</translation>
    </message>
    <message>
        <source>What stays in its place while scaled and turned.</source>
        <translation>O que fica no lugar ao escalar e girar.</translation>
    </message>
    <message>
        <source>How far it is moved, last.</source>
        <translation>Quanto é movido, por último.</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>In place of all that: 16 numbers row by row, applied to columns (x, y, z, 1).</source>
        <translation>No lugar de tudo isso: 16 números linha por linha, aplicados a colunas (x, y, z, 1).</translation>
    </message>
    <message>
        <source>Of all edges.</source>
        <translation>De todas as arestas.</translation>
    </message>
    <message>
        <source>Planes by which one face turns into its neighbour; 2 makes chamfers.</source>
        <translation>Planos pelos quais uma face passa à vizinha; 2 faz chanfros.</translation>
    </message>
    <message>
        <source>In the plane of the section, from start to end; an end on the boundary opens there.</source>
        <translation>No plano da seção, do início ao fim; uma ponta na fronteira abre-se ali.</translation>
    </message>
    <message>
        <source>Names of parts; the last part where left out.</source>
        <translation>Nomes de peças; a última se omitido.</translation>
    </message>
    <message>
        <source>a, b, c, d of the plane a x + b y + c z + d = 0; the section is seen from where that is positive.</source>
        <translation>a, b, c, d do plano a x + b y + c z + d = 0; a seção é vista de onde isso é positivo.</translation>
    </message>
    <message>
        <source>Drawn in the section.</source>
        <translation>Desenhadas na seção.</translation>
    </message>
    <message>
        <source>By default that of the file.</source>
        <translation>Por padrão, o do arquivo.</translation>
    </message>
    <message>
        <source>A scenario of RECON (.toml), whose input is meant, or lines in any format.</source>
        <translation>Um cenário do RECON (.toml), do qual vale a entrada, ou linhas em qualquer formato.</translation>
    </message>
    <message>
        <source>Trace on the map</source>
        <translation>Traço no mapa</translation>
    </message>
    <message>
        <source>x0, y0, x1, y1 and further corners, from the left end of the section; by default that of its scenario.</source>
        <translation>x0, y0, x1, y1 e mais vértices, a partir da ponta esquerda da seção; por padrão, o do seu cenário.</translation>
    </message>
    <message>
        <source>Sections in space</source>
        <translation>Seções no espaço</translation>
    </message>
    <message>
        <source>Fault block</source>
        <translation>Bloco falhado</translation>
    </message>
    <message>
        <source>A section carried along strike, cut at an angle, and restored.</source>
        <translation>Uma seção levada ao longo da direção, cortada em ângulo e restaurada.</translation>
    </message>
    <message>
        <source>Several sections with their traces on the map, instead of the lines of one; for surface and cut.</source>
        <translation>Várias seções com seus traços no mapa, em lugar das linhas de uma; para surface e cut.</translation>
    </message>
    <message>
        <source>x0, y0, x1, y1 and further corners: where the new section runs, from its left end to its right.</source>
        <translation>x0, y0, x1, y1 e mais vértices: por onde passa a nova seção, da ponta esquerda à direita.</translation>
    </message>
    <message>
        <source>Horizons and faults as surfaces through equally named lines of several sections.</source>
        <translation>Horizontes e falhas como superfícies por linhas de mesmo nome em várias seções.</translation>
    </message>
    <message>
        <source>Cut a section</source>
        <translation>Cortar uma seção</translation>
    </message>
    <message>
        <source>A new section where a trace crosses the surfaces; the steps behind work on it.</source>
        <translation>Uma nova seção onde um traço cruza as superfícies; os passos seguintes trabalham nela.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Nova seção</translation>
    </message>
    <message>
        <source>GOCAD: surfaces</source>
        <translation>GOCAD: superfícies</translation>
    </message>
    <message>
        <source>Greatest mis-tie</source>
        <translation>Maior desencontro</translation>
    </message>
    <message>
        <source>Where two sections cross, lines of one name that are farther apart are refused, others meet half-way; by default 0.02 of the size of all.</source>
        <translation>Onde duas seções se cruzam, linhas de um nome que distam mais são recusadas, as outras se encontram no meio; por padrão, 0.02 do tamanho do todo.</translation>
    </message>
    <message>
        <source>Rows from section to section</source>
        <translation>Fileiras de seção a seção</translation>
    </message>
    <message>
        <source>Of triangles, in files, pictures and between the sections of a cut.</source>
        <translation>De triângulos, em arquivos, imagens e entre as seções de um corte.</translation>
    </message>
    <message>
        <source>Ends at faults</source>
        <translation>Pontas em falhas</translation>
    </message>
    <message>
        <source>A horizon that ends nearer to a fault than this part of its section&apos;s size ends at the fault.</source>
        <translation>Um horizonte que termina mais perto de uma falha que esta parte do tamanho da seção termina na falha.</translation>
    </message>
    <message>
        <source>Interval of contours</source>
        <translation>Intervalo das curvas de nível</translation>
    </message>
    <message>
        <source>Lines of one height every so many metres.</source>
        <translation>Linhas de mesma altura a cada tantos metros.</translation>
    </message>
    <message>
        <source>Surfaces through four sections, and a fifth cut and restored.</source>
        <translation>Superfícies por quatro seções, e uma quinta cortada e restaurada.</translation>
    </message>
    <message>
        <source>Simplify lines</source>
        <translation>Simplificar linhas</translation>
    </message>
    <message>
        <source>Vertices are dropped that are nearer than this to the line without them; 0 keeps all.</source>
        <translation>Descartam-se vértices que distam menos que isso da linha sem eles; 0 mantém todos.</translation>
    </message>
</context>
</TS>
